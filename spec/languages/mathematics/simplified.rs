//! A computation without the operations that a reader does not need.

use crate::numbers::source::{Graph, Node, Operation, Place};

/// The same mathematics without sums with zero, products with one and with zero, and quotients by one. Products of a number with itself are squares.
pub(super) fn simplified(graph: &Graph) -> Graph {
    let (mut nodes, mut moved): (Vec<Node>, Vec<Place>) = (vec![], vec![]);
    for node in &graph.nodes {
        let node = match node {
            Node::Apply(operation, operands) => {
                Node::Apply(*operation, operands.iter().map(|place| moved[*place as usize]).collect())
            }
            leaf => leaf.clone(),
        };
        let place = match simpler(&nodes, node) {
            Simpler::Same(place) => place,
            Simpler::New(node) => nodes.iter().position(|other| *other == node).unwrap_or_else(|| {
                nodes.push(node);
                nodes.len() - 1
            }) as Place,
        };
        moved.push(place);
    }
    let results = graph.results.iter().map(|place| moved[*place as usize]).collect();
    Graph { nodes, results, lists: graph.lists.clone() }.without_unused()
}

enum Simpler {
    /// What is there already.
    Same(Place),
    New(Node),
}

fn simpler(nodes: &[Node], node: Node) -> Simpler {
    let Node::Apply(operation, operands) = &node else { return Simpler::New(node) };
    let is = |k: usize, value: f64| matches!(nodes[operands[k] as usize], Node::Literal(bits) if f64::from_bits(bits) == value);
    match operation {
        Operation::Add if is(0, 0.0) => Simpler::Same(operands[1]),
        Operation::Add | Operation::Sub if is(1, 0.0) => Simpler::Same(operands[0]),
        Operation::Sub if is(0, 0.0) => Simpler::New(Node::Apply(Operation::Neg, vec![operands[1]])),
        Operation::Mul if is(0, 1.0) || is(1, 0.0) => Simpler::Same(operands[1]),
        Operation::Mul if is(1, 1.0) || is(0, 0.0) => Simpler::Same(operands[0]),
        Operation::Div if is(1, 1.0) || is(0, 0.0) => Simpler::Same(operands[0]),
        Operation::Mul if operands[0] == operands[1] => {
            Simpler::New(Node::Apply(Operation::Squared, vec![operands[0]]))
        }
        _ => Simpler::New(node),
    }
}
