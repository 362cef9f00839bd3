//! Fortran 2008: a module of pure procedures.

use super::Syntax;
use super::comment::wrapped;
use super::procedure::{Procedure, Statement, Value, places};

pub(super) struct Fortran;

/// Longest line; the standard allows 132 characters.
const WIDTH: usize = 110;

const HELPERS: &str = r#"module veridem
  use, intrinsic :: iso_fortran_env, only: int64, real64
  implicit none
  private
  integer, parameter :: wp = real64
  real(wp), parameter :: infinite = transfer(9218868437227405312_int64, 0.0_wp)
  real(wp), parameter :: not_a_number = transfer(9221120237041090560_int64, 0.0_wp)
"#;

const FUNCTIONS: &str = r#"  ! The power of two of a normal number.
  elemental real(wp) function veridem_exponent(x)
    real(wp), intent(in) :: x
    veridem_exponent = real(iand(ishft(transfer(x, 0_int64), -52), 2047_int64) - 1023_int64, wp)
  end function

  ! Two to the power of a whole number, to which 3/2 2^52 has been added.
  elemental real(wp) function veridem_power_of_two(shifted)
    real(wp), intent(in) :: shifted
    veridem_power_of_two = transfer(ishft(iand(transfer(shifted, 0_int64), 4095_int64) + 1023_int64, 52), 0.0_wp)
  end function

  elemental real(wp) function veridem_floor(x)
    real(wp), intent(in) :: x
    veridem_floor = x
    if (abs(x) < 4503599627370496.0_wp) then
      veridem_floor = aint(x)
      if (veridem_floor > x) veridem_floor = veridem_floor - 1.0_wp
      veridem_floor = sign(veridem_floor, x)
    end if
  end function

  elemental real(wp) function veridem_abs(x)
    real(wp), intent(in) :: x
    veridem_abs = merge(-x, x, x < 0.0_wp)
  end function

  elemental real(wp) function veridem_min(a, b)
    real(wp), intent(in) :: a, b
    veridem_min = merge(a, b, a < b)
  end function

  elemental real(wp) function veridem_max(a, b)
    real(wp), intent(in) :: a, b
    veridem_max = merge(a, b, b < a)
  end function
"#;

impl Syntax for Fortran {
    fn reserved(&self) -> &'static [&'static str] {
        &[
            "sqrt",
            "merge",
            "wp",
            "infinite",
            "not_a_number",
            "real",
            "transfer",
            "int64",
            "real64",
            "end",
            "return",
            "if",
        ]
    }
    fn literal(&self, value: f64) -> String {
        match value {
            f64::INFINITY => "infinite".into(),
            f64::NEG_INFINITY => "-infinite".into(),
            _ if value.is_nan() => "not_a_number".into(),
            _ => format!("{value:?}_wp"),
        }
    }
    fn logic(&self) -> [&'static str; 3] {
        [".and.", ".or.", ".not. "]
    }
    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("merge({yes}, {no}, {condition})")
    }
    fn function(&self, name: &'static str) -> String {
        match name {
            "sqrt" => name.into(),
            _ => format!("veridem_{name}"),
        }
    }
    fn component(&self, name: &str, k: usize) -> String {
        format!("{name}({})", k + 1)
    }
    fn comment(&self) -> &'static str {
        "!"
    }
    fn procedure(&self, procedure: &Procedure, comment: &str) -> String {
        let name = &procedure.name;
        let shape = |value: &Value| match value.size {
            1 => value.name.clone(),
            size => format!("{}({size})", value.name),
        };
        let declared = |values: &[Value], intent: &str| -> String {
            values.iter().map(|value| format!("real(wp){intent} :: {}\n", shape(value))).collect()
        };
        let mut parameters: Vec<&str> = procedure.arguments.iter().map(|value| value.name.as_str()).collect();
        let (kind, result, intent) = match procedure.single() {
            Some(value) => ("function", format!(" result({})", value.name), ""),
            None => {
                parameters.extend(procedure.results.iter().map(|value| value.name.as_str()));
                ("subroutine", String::new(), ", intent(out)")
            }
        };
        let locals = |kind: &str, is_condition: bool| -> String {
            let of_kind = procedure.statements.iter().filter(|s| s.is_condition == is_condition);
            of_kind.map(|s| format!("{kind} :: {}\n", s.name)).collect()
        };
        let statement = |s: &Statement| format!("{} = {}\n", s.name, s.expression);
        let body: String = procedure.statements.iter().map(statement).collect();
        let assigned = places(self, &procedure.results);
        let end: String =
            assigned.iter().zip(&procedure.outputs).map(|(to, from)| format!("{to} = {from}\n")).collect();
        let inside = [
            declared(&procedure.arguments, ", intent(in)"),
            declared(&procedure.results, intent),
            locals("real(wp)", false),
            locals("logical", true),
            body,
            end,
        ]
        .concat();
        let head = broken(&format!("  pure {kind} {name}({}){result}", parameters.join(", ")));
        let inside: String = inside.lines().map(|line| broken(&format!("    {line}"))).collect();
        format!("{}{head}{inside}  end {kind}\n", wrapped(comment, "  !"))
    }
    fn module(&self, head: &str, functions: &[String], procedures: &[Procedure], texts: &[String]) -> String {
        let flags = wrapped(
            "Compile without contraction and without relaxed arithmetic: -ffp-contract=off -fno-range-check, never -ffast-math. Vectors are arrays of three, tensors of \
             nine, rows first; results are not written to variables of arguments.",
            self.comment(),
        );
        let public: String = procedures.iter().map(|procedure| format!("  public :: {}\n", procedure.name)).collect();
        format!(
            "{head}{flags}{HELPERS}{public}contains\n{FUNCTIONS}\n{}\n{}end module\n",
            functions.join("\n"),
            texts.join("\n")
        )
    }
}

/// A line, continued where it is too long.
fn broken(line: &str) -> String {
    let indent = line.len() - line.trim_start().len();
    let (mut out, mut now) = (String::new(), String::new());
    for (k, word) in line.trim_start().split(' ').enumerate() {
        if k > 0 && now.len() + word.len() >= WIDTH {
            out += &format!("{now} &\n");
            now = " ".repeat(indent + 4);
        } else if k > 0 {
            now.push(' ');
        } else {
            now = " ".repeat(indent);
        }
        now.push_str(word);
    }
    format!("{out}{now}\n")
}
