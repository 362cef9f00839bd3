//! A computation as a graph: what [`Source`](super::Source) records.

use crate::Real;
use crate::numbers::bits::Bits;

/// The place of a node in its graph.
pub type Place = u32;

/// What a node does with its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is the method of `Real` or the operator that it is named after")]
pub enum Operation {
    Add,
    Sub,
    Mul,
    Div,
    Neg,
    Squared,
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Acos,
    Tanh,
    Floor,
    Abs,
    Min,
    Max,
    /// Of a condition and two numbers.
    Select,
    Lt,
    Le,
    And,
    Or,
    Not,
    /// See [`Bits::exponent`].
    Exponent,
    /// See [`Bits::power_of_two`].
    PowerOfTwo,
    /// The entry of a list at a place.
    Entry(usize),
}

impl Operation {
    /// Whether it yields a condition, not a number.
    pub fn is_condition(self) -> bool {
        matches!(self, Self::Lt | Self::Le | Self::And | Self::Or | Self::Not)
    }
}

/// One step of a computation.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// An argument, counted from zero.
    Argument(usize),
    /// The bits of a literal.
    Literal(u64),
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// The truth or falsehood of a condition that depends on no argument.
    Always(bool),
    /// An operation on earlier nodes.
    Apply(Operation, Vec<Place>),
}

/// A computation without branches: every node comes after its operands, and none stands twice.
#[derive(Clone, Debug)]
pub struct Graph {
    /// The nodes; results and what they need alone.
    pub nodes: Vec<Node>,
    /// The places of the results.
    pub results: Vec<Place>,
    /// The lists that entries are taken from.
    pub lists: Vec<Vec<f64>>,
}

impl Graph {
    /// Drops nodes that no result needs.
    pub(crate) fn without_unused(self) -> Self {
        let mut needed = vec![false; self.nodes.len()];
        self.results.iter().for_each(|place| needed[*place as usize] = true);
        for place in (0..self.nodes.len()).rev() {
            if let (true, Node::Apply(_, operands)) = (needed[place], &self.nodes[place]) {
                operands.iter().for_each(|operand| needed[*operand as usize] = true);
            }
        }
        let (mut nodes, mut moved) = (Vec::new(), vec![0; self.nodes.len()]);
        for (place, mut node) in self.nodes.into_iter().enumerate().filter(|(place, _)| needed[*place]) {
            if let Node::Apply(_, operands) = &mut node {
                operands.iter_mut().for_each(|operand| *operand = moved[*operand as usize]);
            }
            moved[place] = nodes.len() as Place;
            nodes.push(node);
        }
        Self { nodes, results: self.results.iter().map(|place| moved[*place as usize]).collect(), lists: self.lists }
    }

    /// How often each node is an operand or a result.
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.nodes.len()];
        for node in &self.nodes {
            if let Node::Apply(_, operands) = node {
                operands.iter().for_each(|operand| uses[*operand as usize] += 1);
            }
        }
        self.results.iter().for_each(|place| uses[*place as usize] += 1);
        uses
    }

    /// Does what was recorded, with numbers of another type.
    pub fn evaluate<R: Bits>(&self, arguments: &[R]) -> Vec<R> {
        enum Value<R: Real> {
            Number(R),
            Condition(R::Mask),
        }
        let mut values: Vec<Value<R>> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let value = match node {
                Node::Argument(k) => Value::Number(arguments[*k]),
                Node::Literal(bits) => Value::Number(R::lit(f64::from_bits(*bits))),
                Node::Pi => Value::Number(R::pi()),
                Node::Always(truth) => Value::Condition(R::always(*truth)),
                Node::Apply(operation, operands) => {
                    let number = |k: usize| match values[operands[k] as usize] {
                        Value::Number(number) => number,
                        Value::Condition(_) => unreachable!("the operand is a number"),
                    };
                    let condition = |k: usize| match values[operands[k] as usize] {
                        Value::Condition(condition) => condition,
                        Value::Number(_) => unreachable!("the operand is a condition"),
                    };
                    match operation {
                        Operation::Lt => Value::Condition(number(0).lt(number(1))),
                        Operation::Le => Value::Condition(number(0).le(number(1))),
                        Operation::And => Value::Condition(condition(0) & condition(1)),
                        Operation::Or => Value::Condition(condition(0) | condition(1)),
                        Operation::Not => Value::Condition(!condition(0)),
                        Operation::Add => Value::Number(number(0) + number(1)),
                        Operation::Sub => Value::Number(number(0) - number(1)),
                        Operation::Mul => Value::Number(number(0) * number(1)),
                        Operation::Div => Value::Number(number(0) / number(1)),
                        Operation::Neg => Value::Number(-number(0)),
                        Operation::Squared => Value::Number(number(0).squared()),
                        Operation::Sqrt => Value::Number(number(0).sqrt()),
                        Operation::Exp => Value::Number(number(0).exp()),
                        Operation::Ln => Value::Number(number(0).ln()),
                        Operation::Sin => Value::Number(number(0).sin()),
                        Operation::Cos => Value::Number(number(0).cos()),
                        Operation::Acos => Value::Number(number(0).acos()),
                        Operation::Tanh => Value::Number(number(0).tanh()),
                        Operation::Floor => Value::Number(number(0).floor()),
                        Operation::Abs => Value::Number(number(0).abs()),
                        Operation::Min => Value::Number(number(0).min(number(1))),
                        Operation::Max => Value::Number(number(0).max(number(1))),
                        Operation::Select => Value::Number(R::select(condition(0), number(1), number(2))),
                        Operation::Exponent => Value::Number(number(0).exponent()),
                        Operation::PowerOfTwo => Value::Number(number(0).power_of_two()),
                        Operation::Entry(list) => Value::Number(R::entry(&self.lists[*list], number(0))),
                    }
                }
            };
            values.push(value);
        }
        let number = |place: &Place| match values[*place as usize] {
            Value::Number(number) => number,
            Value::Condition(_) => unreachable!("a result is a number"),
        };
        self.results.iter().map(number).collect()
    }
}
