//! The equations in other programming languages, with the bits of this program.
//!
//! An equation that is evaluated with [`Source`] is a graph; here it becomes a procedure. Every operation stays where it is: sums are not
//! reordered, nothing is fused. Functions beyond arithmetic and the square root are written out, as the libraries of languages differ in their last bits.

mod c;
mod comment;
mod fortran;
mod javascript;
mod law;
pub mod mathematics;
mod procedure;
mod python;

use crate::document::{Document, Quantity};
use crate::equation::Equation;
use crate::numbers::source::{Graph, Node, Operation, Source};
use crate::numbers::written;
use comment::comment;
pub use law::law;
use procedure::{Procedure, Value};

/// A programming language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C99: a header.
    C,
    /// Python 3: a module.
    Python,
    /// JavaScript: a module of ECMAScript 2015.
    Javascript,
    /// Fortran 2008: a module.
    Fortran,
}

/// What the languages write differently.
trait Syntax {
    /// Words that no argument and no variable may be named.
    fn reserved(&self) -> &'static [&'static str];
    /// A number, so that it is read as the same bits.
    fn literal(&self, value: f64) -> String;
    /// `and`, `or`, `not`; those of C, unless a language has its own.
    fn logic(&self) -> [&'static str; 3] {
        ["&&", "||", "!"]
    }
    /// A choice between two numbers.
    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("{condition} ? {yes} : {no}")
    }
    /// The name of a function of one or two numbers.
    fn function(&self, name: &'static str) -> String;
    /// A quotient, where it is not an operator.
    fn quotient(&self, _dividend: &str, _divisor: &str) -> Option<String> {
        None
    }
    /// A component of a vector, counted from zero.
    fn component(&self, name: &str, k: usize) -> String {
        format!("{name}[{k}]")
    }
    /// The mark before every line of a comment.
    fn comment(&self) -> &'static str {
        "//"
    }
    /// A procedure that others call, with its comment, or one of the functions written out.
    fn procedure(&self, procedure: &Procedure, comment: &str) -> String;
    /// The module: what it says of itself, and its procedures.
    fn module(&self, head: &str, functions: &[String], procedures: &[Procedure], text: &[String]) -> String;
}

/// An argument or a result of what is exported: one number, or several as an array.
pub struct Row {
    /// Its name.
    pub name: String,
    /// How many numbers it is.
    pub size: usize,
    /// Its unit.
    pub unit: String,
    /// The values that are allowed.
    pub domain: String,
    /// What it is.
    pub meaning: String,
}

/// A procedure before it is written in a language.
pub struct Exported {
    /// The id under which it is asked for.
    pub id: String,
    /// The name of the procedure.
    pub name: String,
    /// What it is, and where it comes from; several lines.
    pub title: String,
    /// Its arguments.
    pub arguments: Vec<Row>,
    /// Its results.
    pub results: Vec<Row>,
    /// The computation.
    pub graph: Graph,
}

impl Exported {
    /// An equation with its documentation, and authors and year of its paper, if it is of one.
    pub fn equation(equation: &Equation, document: &Document, reference: &str) -> Self {
        let rows = |quantities: &[Quantity]| -> Vec<Row> { quantities.iter().map(Row::of).collect() };
        let title = document.title.replace("**", "").replace(['\n', '`', '$'], " ").replace("  ", " ");
        let source = match equation.covers {
            _ if reference.is_empty() => String::new(),
            [] => format!("\n{reference}."),
            [number] => format!("\n{reference}, Eq. {number}."),
            numbers => format!("\n{reference}, Eqs. {}.", numbers.join(", ")),
        };
        Self {
            id: equation.id.into(),
            name: name(equation),
            title: format!("{}: {title}{source}", equation.id),
            arguments: rows(&document.arguments),
            results: rows(&document.results),
            graph: graph(equation),
        }
    }

    /// Why it cannot be exported, if it cannot.
    pub fn refusal(&self) -> Option<&'static str> {
        let looks_up = |node: &Node| matches!(node, Node::Apply(Operation::Entry(_), _));
        self.graph.nodes.iter().any(looks_up).then_some("it looks up entries of a table that is made at run time")
    }
}

impl Row {
    fn of(q: &Quantity) -> Self {
        let (unit, domain) = (q.unit.clone(), q.domain.to_string());
        Self { name: q.name.clone(), size: q.size, unit, domain, meaning: q.meaning.replace(['$', '`'], "") }
    }
}

/// Records an equation.
pub fn graph(equation: &Equation) -> Graph {
    Graph::of((equation.shape)().arguments.iter().sum(), equation.eval.source)
}

type Function = fn(Source) -> Source;

/// The functions that are written out.
const FUNCTIONS: [(Operation, &str, &str, Function); 6] = [
    (Operation::Exp, "exp", "Exponential function.", written::exp),
    (Operation::Ln, "ln", "Natural logarithm.", written::ln),
    (Operation::Sin, "sin", "Sine of an angle in radians below 2^20 pi/2; of others it is not a number.", written::sin),
    (
        Operation::Cos,
        "cos",
        "Cosine of an angle in radians below 2^20 pi/2; of others it is not a number.",
        written::cos,
    ),
    (Operation::Acos, "acos", "The angle in radians with this cosine.", written::acos),
    (Operation::Tanh, "tanh", "Hyperbolic tangent.", written::tanh),
];

/// The notice that comes with the functions written out.
const NOTICE: &str = "Logarithm, sine, cosine, inverse cosine and hyperbolic tangent are those of FreeBSD's msun: Copyright (C) 1993 by Sun Microsystems, Inc. \
All rights reserved. Developed at SunPro, a Sun Microsystems, Inc. business. Permission to use, copy, modify, and distribute this software is freely granted, \
provided that this notice is preserved.";

/// The name of an equation's procedure: its id, and the function where that is a number, such as `wear_3_normal_force`.
pub fn name(equation: &Equation) -> String {
    let id = equation.id.replace('-', "_");
    if equation.covers.is_empty() { id } else { format!("{id}_{}", equation.function) }
}

impl Language {
    fn syntax(self) -> &'static dyn Syntax {
        match self {
            Self::C => &c::C,
            Self::Python => &python::Python,
            Self::Javascript => &javascript::Javascript,
            Self::Fortran => &fortran::Fortran,
        }
    }

    /// A header or module with these procedures. Those that cannot be exported are named in its head, with the reason.
    pub fn module(self, all: &[Exported]) -> String {
        let syntax = self.syntax();
        let (mut procedures, mut texts, mut refused, mut needed) = (vec![], vec![], vec![], [false; FUNCTIONS.len()]);
        for exported in all {
            if let Some(reason) = exported.refusal() {
                refused.push(format!("{} is left out: {reason}.", exported.id));
                continue;
            }
            for (needed, (operation, ..)) in needed.iter_mut().zip(&FUNCTIONS) {
                *needed |=
                    exported.graph.nodes.iter().any(|node| matches!(node, Node::Apply(of, _) if of == operation));
            }
            let values = |rows: &[Row]| -> Vec<Value> {
                rows.iter().map(|row| Value { name: row.name.clone(), size: row.size }).collect()
            };
            let (arguments, results) = (values(&exported.arguments), values(&exported.results));
            let procedure = Procedure::new(syntax, exported.name.clone(), arguments, results, &exported.graph);
            texts.push(syntax.procedure(&procedure, &comment(exported, &procedure)));
            procedures.push(procedure);
        }
        let functions: Vec<String> = needed
            .iter()
            .zip(&FUNCTIONS)
            .filter(|(needed, _)| **needed)
            .map(|(_, (_, name, meaning, function))| {
                let graph = Graph::of(1, |x| vec![function(x[0])]);
                let value = |name: &str| vec![Value { name: name.into(), size: 1 }];
                let procedure = Procedure::new(syntax, syntax.function(name), value("x"), value("value"), &graph);
                syntax.procedure(&Procedure { private: true, ..procedure }, meaning)
            })
            .collect();
        let head =
            [vec![HEAD.to_string()], refused, if functions.is_empty() { vec![] } else { vec![NOTICE.into()] }].concat();
        syntax.module(&comment::wrapped(&head.join("\n"), syntax.comment()), &functions, &procedures, &texts)
    }
}

const HEAD: &str = "Equations of published contact models for the discrete element method, in SI or any other consistent units.
Generated by `veridem eq export`, with the bits of that program in IEEE 754 double precision: no operation is reordered or fused, and the functions beyond \
arithmetic and the square root are written out.";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Real;

    fn module(language: Language, id: &str) -> String {
        let equation = crate::equations().into_iter().find(|equation| equation.id == id).unwrap();
        let document = Document::of(&equation).unwrap();
        language.module(&[Exported::equation(&equation, &document, "Somebody 2020")])
    }

    #[test]
    fn a_procedure_reads_like_its_equation() {
        let expected = "\
// wear-3: Eq. 3, Section 2.1: normal force between two particles as a function of their separation.
// Somebody 2020, Eq. 3.
//   k_n      N/m  > 0  normal stiffness
//   delta_e  m    > 0  elastic separation
//   delta_f  m    > 0  fracture separation
//   delta_n  m    any  separation of the surfaces, negative for an overlap
//   -> f_n   N    any  force along the normal, positive when it attracts
export function wear_3_normal_force(k_n, delta_e, delta_f, delta_n) {
  const t1 = delta_n <= delta_f ? k_n * delta_e * (delta_f - delta_n) / (delta_f - delta_e) : 0.0;
  return delta_n <= _min(delta_e, delta_f) ? k_n * delta_n : t1;
}
";
        let module = module(Language::Javascript, "wear-3");
        assert!(module.ends_with(expected), "{module}");
    }

    #[test]
    fn functions_come_with_the_equations_that_need_them() {
        for language in [Language::C, Language::Python, Language::Javascript, Language::Fortran] {
            let (with, without) = (module(language, "titania-14"), module(language, "wear-3"));
            assert!(with.contains("Exponential function.") && with.contains("Sun Microsystems"));
            assert!(!with.contains("Natural logarithm.") && !without.contains("Sun Microsystems"));
        }
    }

    #[test]
    fn a_computation_that_looks_up_a_table_is_left_out_with_the_reason() {
        let graph = Graph::of(1, |x| vec![Source::entry(&[1.0, 2.0], x[0])]);
        let (name, title) = (String::from("looked_up"), String::new());
        let looked_up = Exported { id: "looked-up".into(), name, title, arguments: vec![], results: vec![], graph };
        let module = Language::Python.module(&[looked_up]);
        assert!(module.contains("# looked-up is left out: it looks up entries of a table"), "{module}");
        assert!(!module.contains("looked_up"));
    }

    #[test]
    fn names_of_procedures_differ_without_regard_to_case() {
        let mut names: Vec<String> = crate::equations().iter().map(|equation| name(equation).to_lowercase()).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
        // The longest name that Fortran allows.
        assert!(names.iter().all(|name| name.len() <= 63));
    }
}
