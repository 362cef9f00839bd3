//! A graph as a sequence of assignments.

use super::Syntax;
use crate::numbers::source::{Graph, Node, Operation, Place};
use std::collections::BTreeSet;

/// An argument or result: a number, a vector of three, a tensor of nine with rows first.
pub(super) struct Value {
    pub name: String,
    pub size: usize,
}

/// A variable that is assigned once.
pub(super) struct Statement {
    pub name: String,
    pub is_condition: bool,
    pub expression: String,
}

/// A procedure of a language.
pub(super) struct Procedure {
    pub name: String,
    /// Whether only other procedures of the module call it.
    pub private: bool,
    pub arguments: Vec<Value>,
    /// Names of arguments that nothing depends on.
    pub unused: Vec<String>,
    pub results: Vec<Value>,
    pub statements: Vec<Statement>,
    /// An expression for each number of the results.
    pub outputs: Vec<String>,
}

/// Longest expression that is written into another one.
const LONGEST: usize = 72;

/// How tightly an expression or a formula holds together; what binds less is put into parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Choice,
    Logic,
    Comparison,
    Sum,
    Product,
    Power,
    Atom,
}

impl Procedure {
    pub(super) fn new(
        syntax: &dyn Syntax,
        name: String,
        arguments: Vec<Value>,
        results: Vec<Value>,
        graph: &Graph,
    ) -> Self {
        let mut names = Names { syntax, used: BTreeSet::new() };
        let mut unique = |values: Vec<Value>, mark: &str| -> Vec<Value> {
            values.into_iter().map(|value| Value { name: names.fresh(&value.name, mark), ..value }).collect()
        };
        let (arguments, results) = (unique(arguments, "_"), unique(results, "_out"));
        let unused = unused(&arguments, graph);
        let writer = Writer { syntax, graph, names, inputs: places(syntax, &arguments), statements: vec![] };
        let (statements, outputs) = writer.write();
        Self { name, private: false, arguments, unused, results, statements, outputs }
    }

    /// The only result, if it is one number.
    pub(super) fn single(&self) -> Option<&Value> {
        match &self.results[..] {
            [value] if value.size == 1 => Some(value),
            _ => None,
        }
    }
}

/// The names of the numbers of some values, laid end to end.
pub(super) fn places(syntax: &dyn Syntax, values: &[Value]) -> Vec<String> {
    let numbers = |value: &Value| -> Vec<String> {
        match value.size {
            1 => vec![value.name.clone()],
            size => (0..size).map(|k| syntax.component(&value.name, k)).collect(),
        }
    };
    values.iter().flat_map(numbers).collect()
}

/// The names of arguments that nothing depends on.
fn unused(arguments: &[Value], graph: &Graph) -> Vec<String> {
    let mut begin = 0;
    let mut is_unused = |value: &&Value| {
        let own = begin..begin + value.size;
        begin = own.end;
        !graph.nodes.iter().any(|node| matches!(node, Node::Argument(k) if own.contains(k)))
    };
    arguments.iter().filter(&mut is_unused).map(|value| value.name.clone()).collect()
}

/// Names that are in use; languages without upper and lower case are served, too.
struct Names<'a> {
    syntax: &'a dyn Syntax,
    used: BTreeSet<String>,
}

impl Names<'_> {
    fn fresh(&mut self, wish: &str, mark: &str) -> String {
        let mut name = wish.to_string();
        while self.syntax.reserved().contains(&name.to_lowercase().as_str()) || self.used.contains(&name.to_lowercase())
        {
            name.push_str(mark);
        }
        self.used.insert(name.to_lowercase());
        name
    }
}

struct Writer<'a> {
    syntax: &'a dyn Syntax,
    graph: &'a Graph,
    names: Names<'a>,
    inputs: Vec<String>,
    statements: Vec<Statement>,
}

impl Writer<'_> {
    fn write(mut self) -> (Vec<Statement>, Vec<String>) {
        let mut uses = self.graph.uses();
        // A square is written as a product of a name with itself.
        for node in &self.graph.nodes {
            if let Node::Apply(Operation::Squared, operands) = node {
                uses[operands[0] as usize] += 1;
            }
        }
        let mut written: Vec<(String, Binding)> = vec![];
        for (place, node) in self.graph.nodes.iter().enumerate() {
            let (text, binding) = self.node(node, &written);
            let named = match node {
                Node::Apply(operation, _) => {
                    let is_result = self.graph.results.contains(&(place as Place));
                    uses[place] > 1 || !is_result && (*operation == Operation::Select || text.len() > LONGEST)
                }
                _ => false,
            };
            written.push(if named {
                let name = self.names.fresh(&format!("t{}", self.statements.len() + 1), "_");
                let is_condition = matches!(node, Node::Apply(operation, _) if operation.is_condition());
                self.statements.push(Statement { name: name.clone(), is_condition, expression: text });
                (name, Binding::Atom)
            } else {
                (text, binding)
            });
        }
        let outputs = self.graph.results.iter().map(|place| written[*place as usize].0.clone()).collect();
        (self.statements, outputs)
    }

    fn node(&self, node: &Node, written: &[(String, Binding)]) -> (String, Binding) {
        match node {
            Node::Argument(k) => (self.inputs[*k].clone(), Binding::Atom),
            Node::Literal(bits) => self.literal(f64::from_bits(*bits)),
            Node::Pi => self.literal(std::f64::consts::PI),
            Node::Always(truth) => {
                let [a, b] = if *truth { [0.0, 1.0] } else { [1.0, 0.0] }.map(|x| self.syntax.literal(x));
                (format!("{a} < {b}"), Binding::Comparison)
            }
            Node::Apply(operation, operands) => {
                let operands: Vec<&(String, Binding)> =
                    operands.iter().map(|place| &written[*place as usize]).collect();
                self.apply(*operation, &operands)
            }
        }
    }

    fn literal(&self, value: f64) -> (String, Binding) {
        (self.syntax.literal(value), if value.is_sign_negative() { Binding::Sum } else { Binding::Atom })
    }

    fn apply(&self, operation: Operation, operands: &[&(String, Binding)]) -> (String, Binding) {
        let at_least = |k: usize, least: Binding| {
            let (text, binding) = operands[k];
            if *binding < least { format!("({text})") } else { text.clone() }
        };
        let infix =
            |sign: &str, left: Binding, right: Binding| format!("{} {sign} {}", at_least(0, left), at_least(1, right));
        let [and, or, not] = self.syntax.logic();
        use Binding::{Atom, Choice, Comparison, Logic, Product, Sum};
        let text = |k: usize| operands[k].0.as_str();
        let call = |name: &'static str| {
            let list: Vec<&str> = operands.iter().map(|operand| operand.0.as_str()).collect();
            (format!("{}({})", self.syntax.function(name), list.join(", ")), Atom)
        };
        match operation {
            Operation::Add => (infix("+", Sum, Product), Sum),
            Operation::Sub => (infix("-", Sum, Product), Sum),
            Operation::Mul => (infix("*", Product, Atom), Product),
            Operation::Div => match self.syntax.quotient(text(0), text(1)) {
                Some(call) => (call, Atom),
                None => (infix("/", Product, Atom), Product),
            },
            Operation::Neg => (format!("-{}", at_least(0, Atom)), Sum),
            Operation::Squared => (format!("{0} * {0}", at_least(0, Atom)), Product),
            Operation::Lt => (infix("<", Sum, Sum), Comparison),
            Operation::Le => (infix("<=", Sum, Sum), Comparison),
            Operation::And => (infix(and, Comparison, Comparison), Logic),
            Operation::Or => (infix(or, Comparison, Comparison), Logic),
            Operation::Not => (format!("{not}({})", text(0)), Atom),
            Operation::Select => (self.syntax.select(text(0), text(1), text(2)), Choice),
            Operation::Sqrt => call("sqrt"),
            Operation::Exp => call("exp"),
            Operation::Ln => call("ln"),
            Operation::Sin => call("sin"),
            Operation::Cos => call("cos"),
            Operation::Acos => call("acos"),
            Operation::Tanh => call("tanh"),
            Operation::Floor => call("floor"),
            Operation::Abs => call("abs"),
            Operation::Min => call("min"),
            Operation::Max => call("max"),
            Operation::Exponent => call("exponent"),
            Operation::PowerOfTwo => call("power_of_two"),
            Operation::Entry(_) => unreachable!("equations that look up tables are refused"),
        }
    }
}
