//! C99: a header of inline functions.

use super::Syntax;
use super::comment::wrapped;
use super::procedure::{Procedure, Value, places};

pub(super) struct C;

const HELPERS: &str = r#"#ifndef VERIDEM_EQUATIONS_H
#define VERIDEM_EQUATIONS_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifdef __FAST_MATH__
#error "-ffast-math changes the results"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

/* The power of two of a normal number. */
static inline double veridem_exponent(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (double)((int64_t)(bits >> 52 & 2047) - 1023);
}
/* Two to the power of a whole number, to which 3/2 2^52 has been added. */
static inline double veridem_power_of_two(double shifted) {
    uint64_t bits;
    memcpy(&bits, &shifted, sizeof bits);
    bits = (bits + 1023) << 52;
    memcpy(&shifted, &bits, sizeof bits);
    return shifted;
}
static inline double veridem_abs(double x) { return x < 0.0 ? -x : x; }
static inline double veridem_min(double a, double b) { return a < b ? a : b; }
static inline double veridem_max(double a, double b) { return b < a ? a : b; }
"#;

impl Syntax for C {
    fn reserved(&self) -> &'static [&'static str] {
        &[
            "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum", "extern",
            "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return", "short", "signed",
            "sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void", "volatile", "while",
            "bits", "sqrt", "floor", "infinity", "nan", "y0", "y1", "j0", "j1", "gamma", "new", "delete", "class",
            "this",
        ]
    }
    fn literal(&self, value: f64) -> String {
        match value {
            f64::INFINITY => "INFINITY".into(),
            f64::NEG_INFINITY => "-INFINITY".into(),
            _ if value.is_nan() => "NAN".into(),
            _ => format!("{value:?}"),
        }
    }
    fn function(&self, name: &'static str) -> String {
        match name {
            "sqrt" | "floor" => name.into(),
            _ => format!("veridem_{name}"),
        }
    }
    fn procedure(&self, procedure: &Procedure, comment: &str) -> String {
        let argument = |value: &Value| match value.size {
            1 => format!("double {}", value.name),
            size => format!("const double {}[{size}]", value.name),
        };
        let result = |value: &Value| match value.size {
            1 => format!("double *{}", value.name),
            size => format!("double {}[{size}]", value.name),
        };
        let mut parameters: Vec<String> = procedure.arguments.iter().map(argument).collect();
        let (kind, end) = match procedure.single() {
            Some(_) => ("double", format!("    return {};\n", procedure.outputs[0])),
            None => {
                parameters.extend(procedure.results.iter().map(result));
                let star =
                    |value: &Value| if value.size == 1 { format!("*{}", value.name) } else { value.name.clone() };
                let targets: Vec<Value> =
                    procedure.results.iter().map(|value| Value { name: star(value), size: value.size }).collect();
                let assigned = places(self, &targets);
                (
                    "void",
                    assigned.iter().zip(&procedure.outputs).map(|(to, from)| format!("    {to} = {from};\n")).collect(),
                )
            }
        };
        let kinds = |is_condition| if is_condition { "int" } else { "double" };
        let statement =
            |s: &super::procedure::Statement| format!("    {} {} = {};\n", kinds(s.is_condition), s.name, s.expression);
        let body: String = procedure.statements.iter().map(statement).collect();
        let unused: String = procedure.unused.iter().map(|name| format!("    (void){name};\n")).collect();
        let name = if procedure.private { procedure.name.clone() } else { format!("veridem_{}", procedure.name) };
        let comment = wrapped(comment, self.comment());
        format!("{comment}static inline {kind} {name}({}) {{\n{unused}{body}{end}}}\n", parameters.join(", "))
    }
    fn module(&self, head: &str, functions: &[String], _: &[Procedure], texts: &[String]) -> String {
        let flags = wrapped(
            "Compile without contraction and without relaxed arithmetic: -ffp-contract=off, never -ffast-math; on 32-bit x86 with -msse2 -mfpmath=sse. Vectors are arrays \
             of three, tensors of nine, rows first; results are not written to arrays of arguments.",
            self.comment(),
        );
        format!("{head}{flags}{HELPERS}\n{}\n{}\n#endif\n", functions.join("\n"), texts.join("\n"))
    }
}
