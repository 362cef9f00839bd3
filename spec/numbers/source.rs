//! A number that records how it is computed: an equation evaluated with it becomes a graph that can be printed.

use super::bits::Bits;
use crate::Real;
use num_traits::{One, Zero};
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

pub use graph::{Graph, Node, Operation, Place};

mod graph;

#[derive(Default)]
struct Recorder {
    nodes: Vec<Node>,
    places: HashMap<Node, Place>,
    lists: Vec<Vec<f64>>,
}

thread_local! {
    static RECORDER: RefCell<Recorder> = RefCell::default();
}

fn record(node: Node) -> Place {
    RECORDER.with_borrow_mut(|recorder| {
        if let Some(place) = recorder.places.get(&node) {
            return *place;
        }
        let place = recorder.nodes.len() as Place;
        recorder.nodes.push(node.clone());
        recorder.places.insert(node, place);
        place
    })
}

fn node(place: Place) -> Node {
    RECORDER.with_borrow(|recorder| recorder.nodes[place as usize].clone())
}

/// A number of a computation that is being recorded, in the thread that records it.
#[derive(Clone, Copy, Debug)]
pub struct Source(Place);

/// The truth of a comparison of such numbers.
#[derive(Clone, Copy, Debug)]
pub struct Condition(Place);

impl Graph {
    /// Records a function with this number of arguments.
    pub fn of(arguments: usize, function: impl FnOnce(&[Source]) -> Vec<Source>) -> Self {
        RECORDER.set(Recorder::default());
        let arguments: Vec<Source> = (0..arguments).map(|k| Source(record(Node::Argument(k)))).collect();
        let results = function(&arguments).into_iter().map(|number| number.0).collect();
        let Recorder { nodes, lists, .. } = RECORDER.take();
        Self { nodes, results, lists }.without_unused()
    }
}

impl Source {
    fn apply<const N: usize>(operation: Operation, operands: [Self; N]) -> Self {
        Self(record(Node::Apply(operation, operands.map(|operand| operand.0).to_vec())))
    }
    fn literal(self) -> Option<f64> {
        match node(self.0) {
            Node::Literal(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }
    /// A comparison; one of literals is decided at once.
    fn compare(self, other: Self, operation: Operation, decide: impl Fn(f64, f64) -> bool) -> Condition {
        Condition(record(match (self.literal(), other.literal()) {
            (Some(a), Some(b)) => Node::Always(decide(a, b)),
            _ => Node::Apply(operation, vec![self.0, other.0]),
        }))
    }
}

impl Condition {
    fn decided(self) -> Option<bool> {
        match node(self.0) {
            Node::Always(truth) => Some(truth),
            _ => None,
        }
    }
}

macro_rules! recorded {
    ($($function:ident $operation:ident),*) => {
        $(fn $function(self) -> Self {
            Self::apply(Operation::$operation, [self])
        })*
    };
}

impl Real for Source {
    type Mask = Condition;
    fn lit(value: f64) -> Self {
        Self(record(Node::Literal(value.to_bits())))
    }
    fn pi() -> Self {
        Self(record(Node::Pi))
    }
    recorded!(sqrt Sqrt, exp Exp, ln Ln, sin Sin, cos Cos, acos Acos, tanh Tanh, floor Floor, abs Abs, squared Squared);
    fn entry(list: &[f64], place: Self) -> Self {
        let list = RECORDER.with_borrow_mut(|recorder| {
            let lists = &mut recorder.lists;
            lists.iter().position(|known| known == list).unwrap_or_else(|| {
                lists.push(list.to_vec());
                lists.len() - 1
            })
        });
        Self::apply(Operation::Entry(list), [place])
    }
    fn lt(self, other: Self) -> Condition {
        self.compare(other, Operation::Lt, |a, b| a < b)
    }
    fn le(self, other: Self) -> Condition {
        self.compare(other, Operation::Le, |a, b| a <= b)
    }
    fn select(mask: Condition, yes: Self, no: Self) -> Self {
        match mask.decided() {
            Some(truth) => {
                if truth {
                    yes
                } else {
                    no
                }
            }
            None if yes.0 == no.0 => yes,
            None => Self(record(Node::Apply(Operation::Select, vec![mask.0, yes.0, no.0]))),
        }
    }
    fn min(self, other: Self) -> Self {
        Self::apply(Operation::Min, [self, other])
    }
    fn max(self, other: Self) -> Self {
        Self::apply(Operation::Max, [self, other])
    }
}

impl Bits for Source {
    recorded!(exponent Exponent, power_of_two PowerOfTwo);
}

impl Zero for Source {
    fn zero() -> Self {
        Self::lit(0.0)
    }
    fn is_zero(&self) -> bool {
        self.literal() == Some(0.0)
    }
}
impl One for Source {
    fn one() -> Self {
        Self::lit(1.0)
    }
}

macro_rules! operator {
    ($($trait:ident $method:ident),*) => {
        $(impl $trait for Source {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::apply(Operation::$trait, [self, other])
            }
        })*
    };
}
operator!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Source {
    type Output = Self;
    fn neg(self) -> Self {
        Self::apply(Operation::Neg, [self])
    }
}
impl BitAnd for Condition {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        match (self.decided(), other.decided()) {
            (Some(false), _) | (_, Some(true)) => self,
            (Some(true), _) | (_, Some(false)) => other,
            _ => Self(record(Node::Apply(Operation::And, vec![self.0, other.0]))),
        }
    }
}
impl BitOr for Condition {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        match (self.decided(), other.decided()) {
            (Some(true), _) | (_, Some(false)) => self,
            (Some(false), _) | (_, Some(true)) => other,
            _ => Self(record(Node::Apply(Operation::Or, vec![self.0, other.0]))),
        }
    }
}
impl Not for Condition {
    type Output = Self;
    fn not(self) -> Self {
        match self.decided() {
            Some(truth) => Self(record(Node::Always(!truth))),
            None => Self(record(Node::Apply(Operation::Not, vec![self.0]))),
        }
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashSet;

    fn same(ours: &[f64], theirs: &[f64]) -> bool {
        let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
        ours.len() == theirs.len() && ours.iter().zip(theirs).all(same)
    }

    #[test]
    fn what_is_recorded_of_every_equation_has_its_bits() {
        let mut runner = proptest::test_runner::TestRunner::deterministic();
        for equation in crate::equations() {
            let count = (equation.shape)().arguments.iter().sum();
            let graph = Graph::of(count, equation.eval.source);
            let number =
                (-3.0..3.0f64, any::<bool>()).prop_map(|(power, sign)| if sign { power.exp2() } else { -power.exp2() });
            let numbers = prop::collection::vec(number, count);
            let checked = runner.run(&numbers, |numbers| {
                let (recorded, computed) = (graph.evaluate(&numbers), (equation.eval.f64)(&numbers));
                prop_assert!(same(&recorded, &computed), "{recorded:?} {computed:?}");
                Ok(())
            });
            assert!(checked.is_ok(), "{}: {checked:?}", equation.id);
        }
    }

    #[test]
    fn nothing_stands_twice_and_nothing_in_vain() {
        for equation in crate::equations() {
            let graph = Graph::of((equation.shape)().arguments.iter().sum(), equation.eval.source);
            assert!(graph.uses().iter().all(|uses| *uses > 0), "{}", equation.id);
            assert_eq!(graph.nodes.iter().collect::<HashSet<_>>().len(), graph.nodes.len(), "{}", equation.id);
        }
    }

    #[test]
    fn what_depends_on_no_argument_is_decided() {
        let graph = Graph::of(1, |x| {
            let (always, never) = (Source::always(true), Source::always(false));
            let sometimes = x[0].lt(Source::one());
            let and = Source::select((always & sometimes) | never, x[0], -x[0]);
            vec![Source::select(never & sometimes, x[0], and), Source::select(!never, x[0], -x[0])]
        });
        let chosen = Node::Apply(Operation::Select, vec![2, 0, 3]);
        let negative = Node::Apply(Operation::Neg, vec![0]);
        let less = Node::Apply(Operation::Lt, vec![0, 1]);
        let expected = [Node::Argument(0), Node::Literal(1.0f64.to_bits()), less, negative, chosen];
        assert_eq!((graph.nodes.as_slice(), graph.results.as_slice()), (expected.as_slice(), [4, 0].as_slice()));
        assert_eq!(graph.evaluate(&[3.0]), [-3.0, 3.0]);
    }

    #[test]
    fn entries_of_lists_are_recorded() {
        let graph = Graph::of(1, |x| vec![Source::entry(&[1.0, 2.0, 4.0, 8.0], x[0]), Source::entry(&[5.0], x[0])]);
        assert_eq!(graph.lists, [vec![1.0, 2.0, 4.0, 8.0], vec![5.0]]);
        assert_eq!(graph.evaluate(&[3.0])[0], 8.0);
    }
}
