//! Clusters of connected spheres: union-find.

/// Groups of things that are linked, directly or through others.
pub struct Clusters {
    parent: Vec<u32>,
}

impl Clusters {
    /// The clusters of `n` things.
    pub fn new(n: usize, links: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut clusters = Self { parent: (0..n as u32).collect() };
        for (i, j) in links {
            clusters.join(i, j);
        }
        clusters
    }

    /// Links two things; false if they hung together before.
    pub fn join(&mut self, i: usize, j: usize) -> bool {
        let (a, b) = (self.root(i), self.root(j));
        // The smaller root wins, so that the result does not depend on the order of the links.
        self.parent[a.max(b)] = a.min(b) as u32;
        a != b
    }

    /// The smallest member of the cluster of `i`: its name.
    pub fn root(&mut self, i: usize) -> usize {
        let mut i = i;
        while self.parent[i] as usize != i {
            self.parent[i] = self.parent[self.parent[i] as usize];
            i = self.parent[i] as usize;
        }
        i
    }

    /// How many clusters there are.
    pub fn count(&mut self) -> usize {
        (0..self.parent.len()).filter(|&i| self.root(i) == i).count()
    }

    /// The members of the largest cluster among the things that `counts`; of equals the one with the smallest member.
    pub fn largest(&mut self, counts: impl Fn(usize) -> bool) -> Vec<usize> {
        let n = self.parent.len();
        let roots: Vec<usize> = (0..n).map(|i| self.root(i)).collect();
        let mut size = vec![0; n];
        for i in (0..n).filter(|&i| counts(i)) {
            size[roots[i]] += 1;
        }
        let Some(best) = (0..n).filter(|&root| size[root] > 0).max_by_key(|&root| (size[root], n - root)) else {
            return Vec::new();
        };
        (0..n).filter(|&i| roots[i] == best && counts(i)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use quickcheck::quickcheck;

    quickcheck! {
        fn two_things_share_a_root_exactly_when_a_path_of_links_joins_them(pairs: Vec<(u8, u8)>) -> bool {
            let n = 24;
            let links: Vec<(usize, usize)> = pairs.iter().map(|&(i, j)| (usize::from(i) % n, usize::from(j) % n)).collect();
            let mut reach = vec![vec![false; n]; n];
            for (i, from_i) in reach.iter_mut().enumerate() { from_i[i] = true; }
            for &(i, j) in &links { reach[i][j] = true; reach[j][i] = true; }
            for k in 0..n { for i in 0..n { for j in 0..n { reach[i][j] |= reach[i][k] && reach[k][j]; } } }
            let mut clusters = Clusters::new(n, links);
            (0..n).all(|i| (0..n).all(|j| (clusters.root(i) == clusters.root(j)) == reach[i][j]))
        }

        fn the_largest_cluster_does_not_depend_on_the_order_of_links(pairs: Vec<(u8, u8)>) -> bool {
            let links: Vec<(usize, usize)> = pairs.iter().map(|&(i, j)| (usize::from(i) % 16, usize::from(j) % 16)).collect();
            let turned: Vec<(usize, usize)> = links.iter().rev().map(|&(i, j)| (j, i)).collect();
            Clusters::new(16, links).largest(|i| i != 3) == Clusters::new(16, turned).largest(|i| i != 3)
        }
    }

    #[test]
    fn only_what_counts_is_counted() {
        let mut clusters = Clusters::new(6, [(0, 1), (1, 2), (3, 4)]);
        assert_eq!(clusters.largest(|_| true), [0, 1, 2]);
        assert_eq!(clusters.largest(|i| i > 1), [3, 4]);
        assert!(clusters.largest(|_| false).is_empty());
    }

    #[test]
    fn clusters_are_named_and_counted_and_of_equals_the_first_is_the_largest() {
        let mut clusters = Clusters::new(7, [(5, 6), (3, 2)]);
        assert_eq!((0..7).map(|i| clusters.root(i)).collect::<Vec<_>>(), [0, 1, 2, 2, 4, 5, 5]);
        assert_eq!(clusters.count(), 5);
        assert_eq!(clusters.largest(|_| true), [2, 3]);
        assert_eq!(clusters.largest(|i| i != 3), [5, 6]);
        // A thing that does not count is no member, even if it is the name.
        assert_eq!(clusters.largest(|i| i == 6 || i == 0), [0]);
        assert!(clusters.join(6, 3) && !clusters.join(5, 2) && !clusters.join(4, 4));
        assert_eq!((clusters.root(6), clusters.count()), (2, 4));
        assert_eq!((Clusters::new(0, []).count(), Clusters::new(0, []).largest(|_| true)), (0, vec![]));
    }
}
