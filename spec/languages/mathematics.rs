//! The form in which an equation is computed, in TeX and with the symbols of its table.

mod simplified;
mod symbols;

use super::procedure::Binding;
use crate::document::Document;
use crate::numbers::source::{Graph, Node, Operation, Place};
use simplified::simplified;
use symbols::{components, number, unused_letter};

/// A formula: a symbol and what it is, both in TeX.
#[derive(Debug)]
pub struct Formula {
    /// The symbol on the left.
    pub symbol: String,
    /// What it equals.
    pub formula: String,
}

/// An equation as it is computed.
#[derive(Debug)]
pub struct Computed {
    /// Expressions that occur more than once, each of which uses only those before it.
    pub parts: Vec<Formula>,
    /// The results, vectors and tensors by component.
    pub results: Vec<Formula>,
}

/// The form in which an equation is computed. Sums with zero and products with one are left out; everything else is where it is evaluated.
pub fn computed(graph: &Graph, document: &Document) -> Computed {
    let graph = simplified(graph);
    let inputs = components(&document.arguments);
    let letter = unused_letter(document);
    let mut writer = Writer { graph: &graph, uses: graph.uses(), inputs, letter, written: vec![], parts: vec![] };
    writer.write();
    let names = components(&document.results);
    let formula = |(symbol, place): (String, &Place)| Formula { symbol, formula: writer.text(*place) };
    let results = names.into_iter().zip(&graph.results).map(formula).collect();
    Computed { parts: writer.parts, results }
}

/// Formulas from this length on are named, even if they occur once.
const LONGEST: usize = 240;

struct Writer<'a> {
    graph: &'a Graph,
    uses: Vec<usize>,
    inputs: Vec<String>,
    letter: &'static str,
    written: Vec<(String, Binding)>,
    parts: Vec<Formula>,
}

impl Writer<'_> {
    fn write(&mut self) {
        for (place, node) in self.graph.nodes.iter().enumerate() {
            let (text, binding) = self.node(node);
            let is_result = self.graph.results.contains(&(place as Place));
            let named = !self.is_plain(place) && self.uses[place] > 1 || !is_result && text.len() > LONGEST;
            self.written.push(if named {
                let symbol = format!("{}_{{{}}}", self.letter, self.parts.len() + 1);
                self.parts.push(Formula { symbol: symbol.clone(), formula: text });
                (symbol, Binding::Atom)
            } else {
                (text, binding)
            });
        }
    }

    /// Whether it is written again where it occurs again: a symbol, a number, or one step from these.
    fn is_plain(&self, place: usize) -> bool {
        let is_leaf = |place: &Place| !matches!(self.graph.nodes[*place as usize], Node::Apply(..));
        match &self.graph.nodes[place] {
            Node::Apply(Operation::Select | Operation::And | Operation::Or, _) => false,
            Node::Apply(_, operands) => operands.iter().all(is_leaf),
            _ => true,
        }
    }

    fn text(&self, place: Place) -> String {
        self.written[place as usize].0.clone()
    }

    fn at_least(&self, place: Place, least: Binding) -> String {
        let (text, binding) = &self.written[place as usize];
        if *binding < least { format!("\\left({text}\\right)") } else { text.clone() }
    }

    fn node(&self, node: &Node) -> (String, Binding) {
        match node {
            Node::Argument(k) => (self.inputs[*k].clone(), Binding::Atom),
            Node::Literal(bits) => {
                let (text, is_atom) = number(f64::from_bits(*bits));
                (text, if is_atom { Binding::Atom } else { Binding::Sum })
            }
            Node::Pi => ("\\pi".into(), Binding::Atom),
            Node::Always(truth) => (format!("\\text{{{truth}}}"), Binding::Atom),
            Node::Apply(operation, operands) => self.apply(*operation, operands),
        }
    }

    fn apply(&self, operation: Operation, operands: &[Place]) -> (String, Binding) {
        use Binding::{Atom, Choice, Comparison, Logic, Power, Product, Sum};
        let infix = |sign: &str, left: Binding, right: Binding| {
            format!("{} {sign} {}", self.at_least(operands[0], left), self.at_least(operands[1], right))
        };
        let text = |k: usize| self.text(operands[k]);
        let function = |name: &str| (format!("\\{name}\\left({}\\right)", text(0)), Power);
        let pair = |name: &str| (format!("\\{name}\\left({}, {}\\right)", text(0), text(1)), Power);
        match operation {
            Operation::Add => (infix("+", Sum, Product), Sum),
            Operation::Sub => (infix("-", Sum, Product), Sum),
            Operation::Mul => {
                let right = self.at_least(operands[1], Power);
                let sign = if right.starts_with(|c: char| c.is_ascii_digit()) { "\\cdot" } else { "\\," };
                (format!("{} {sign} {right}", self.at_least(operands[0], Product)), Product)
            }
            Operation::Div => (format!("\\frac{{{}}}{{{}}}", text(0), text(1)), Power),
            Operation::Neg => (format!("-{}", self.at_least(operands[0], Product)), Sum),
            Operation::Squared => {
                let base = self.at_least(operands[0], Atom);
                let has_power = base.contains(['^', '\'']) && !base.starts_with("\\left(");
                (if has_power { format!("{{{base}}}^2") } else { format!("{base}^2") }, Power)
            }
            Operation::Sqrt => (format!("\\sqrt{{{}}}", text(0)), Atom),
            Operation::Abs => (format!("\\left|{}\\right|", text(0)), Atom),
            Operation::Floor => (format!("\\left\\lfloor {}\\right\\rfloor", text(0)), Atom),
            Operation::Exp => function("exp"),
            Operation::Ln => function("ln"),
            Operation::Sin => function("sin"),
            Operation::Cos => function("cos"),
            Operation::Acos => function("arccos"),
            Operation::Tanh => function("tanh"),
            Operation::Min => pair("min"),
            Operation::Max => pair("max"),
            Operation::Lt => (infix("<", Sum, Sum), Comparison),
            Operation::Le => (infix("\\le", Sum, Sum), Comparison),
            Operation::And => (infix("\\land", Comparison, Comparison), Logic),
            Operation::Or => (infix("\\lor", Comparison, Comparison), Logic),
            Operation::Not => self.negation(operands[0]),
            Operation::Select => (self.cases(operands), Choice),
            Operation::Exponent => (format!("\\left\\lfloor \\log_2\\left|{}\\right|\\right\\rfloor", text(0)), Atom),
            Operation::PowerOfTwo => (format!("2^{{{} - 3 \\cdot 2^{{51}}}}", self.at_least(operands[0], Sum)), Power),
            Operation::Entry(_) => (format!("\\mathrm{{table}}\\left({}\\right)", text(0)), Power),
        }
    }

    fn negation(&self, of: Place) -> (String, Binding) {
        match &self.graph.nodes[of as usize] {
            Node::Apply(operation @ (Operation::Lt | Operation::Le), operands) => {
                let sign = if *operation == Operation::Lt { "\\ge" } else { ">" };
                let [left, right] = [0, 1].map(|k| self.at_least(operands[k], Binding::Sum));
                (format!("{left} {sign} {right}"), Binding::Comparison)
            }
            _ => (format!("\\lnot\\left({}\\right)", self.text(of)), Binding::Atom),
        }
    }

    /// The rows of a choice; a choice that occurs only as the last row of another one continues it.
    fn cases(&self, operands: &[Place]) -> String {
        let (mut rows, mut operands) = (String::new(), operands);
        loop {
            rows += &format!("{} & {} \\\\ ", self.text(operands[1]), self.text(operands[0]));
            let last = operands[2];
            match &self.graph.nodes[last as usize] {
                Node::Apply(Operation::Select, next) if self.written[last as usize].1 == Binding::Choice => {
                    operands = next
                }
                _ => return format!("\\begin{{cases}} {rows}{} & \\text{{otherwise}} \\end{{cases}}", self.text(last)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::languages::graph;

    fn computed_of(id: &str) -> Computed {
        let equation = crate::equations().into_iter().find(|equation| equation.id == id).unwrap();
        computed(&graph(&equation), &Document::of(&equation).unwrap())
    }

    #[test]
    fn a_formula_has_the_symbols_of_the_table() {
        let Computed { parts, results } = computed_of("wear-3");
        assert!(parts.is_empty());
        assert_eq!(results[0].symbol, "F_N");
        let cases = "\\begin{cases} k_N \\, \\delta_N & \\delta_N \\le \\min\\left(\\delta_e, \\delta_f\\right) \\\\ \
                     \\frac{k_N \\, \\delta_e \\, \\left(\\delta_f - \\delta_N\\right)}{\\delta_f - \\delta_e} & \\delta_N \\le \\delta_f \\\\ \
                     0 & \\text{otherwise} \\end{cases}";
        assert_eq!(results[0].formula, cases);
    }

    #[test]
    fn every_bracket_is_closed() {
        for equation in crate::equations() {
            let Computed { parts, results } = computed_of(equation.id);
            for Formula { symbol, formula } in parts.iter().chain(&results) {
                let count = |what: &str| format!("{symbol}{formula}").matches(what).count();
                assert_eq!(count("{"), count("}"), "{}: {symbol} = {formula}", equation.id);
                assert_eq!(count("\\left"), count("\\right"), "{}: {symbol} = {formula}", equation.id);
            }
        }
    }
}
