//! Rewrites a source file: each place that can be changed becomes a choice between what is written and its mutants.

use std::collections::BTreeSet;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprIf, ExprLit, ExprMethodCall, ExprUnary, ItemFn, Lit, Stmt, UnOp};

/// A change of the specification or the engine.
#[derive(Clone, Debug)]
pub(crate) struct Mutant {
    /// Its number.
    pub id: u32,
    /// Its name in what is kept between runs: the digest of its file's code, and its place among the mutants of the file.
    pub key: String,
    /// The folder of what is changed, `spec` or `src`.
    pub part: &'static str,
    /// The file, relative to this folder.
    pub file: String,
    /// The line.
    pub line: usize,
    /// The function it is in.
    pub function: String,
    /// What is written there, and what becomes of it.
    pub change: String,
}

impl Mutant {
    /// What is changed, in a line of `survivors.txt`.
    pub(crate) fn sentence(&self) -> String {
        format!("{}/{}, {}, {}", self.part, self.file, self.function, self.change)
    }
}

/// An equation of the list, as far as the sweep needs it.
#[derive(Clone, Debug)]
pub(crate) struct Listed {
    /// Its name in the list.
    pub id: String,
    /// Its function.
    pub function: String,
    /// The file, relative to the specification.
    pub file: String,
    /// Names of its laws.
    pub laws: Vec<String>,
    /// Number of the mutant that multiplies its result by 1.01; those by 0 and by -1 follow.
    pub first: u32,
}

/// Which mutants a copy has.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The result of each equation, times a factor.
    Scaled,
    /// Operators, comparisons, constants, branches and functions of the specification.
    Changed,
    /// The same of the engine, and its conditions, assignments and calls.
    Engine,
}

impl Kind {
    /// The folder whose files are changed.
    pub(crate) fn part(self) -> &'static str {
        if self == Self::Engine { "src" } else { "spec" }
    }
}

/// A rewritten file.
pub(crate) struct Rewritten {
    pub text: String,
    pub mutants: Vec<Mutant>,
    pub listed: Vec<Listed>,
    /// The number after the last of its mutants.
    pub next: u32,
}

/// Rewrites a file, of which `parsed` is the text that is Rust, byte for byte at the same places. Numbers of mutants begin at `first`;
/// those of `dropped` do not compile and keep their numbers.
pub(crate) fn rewrite(
    kind: Kind,
    file: &str,
    source: &str,
    parsed: &str,
    digest: &str,
    first: u32,
    dropped: &BTreeSet<String>,
    entries: &[Entry],
) -> Rewritten {
    let tree = syn::parse_file(parsed).unwrap_or_else(|error| panic!("{}/{file}: {error}", kind.part()));
    let mut rewriter = Rewriter {
        kind,
        file,
        source,
        digest,
        dropped,
        first,
        next: first,
        function: vec![],
        entries,
        edits: vec![],
        mutants: vec![],
        listed: vec![],
    };
    rewriter.visit_file(&tree);
    let Rewriter { mut edits, mutants, listed, next, .. } = rewriter;
    edits.sort_by_key(|edit| (edit.start, edit.opens, edit.order));
    let (mut text, mut at) = (String::new(), 0);
    for edit in edits {
        text += &source[at..edit.start];
        text += &edit.text;
        at = edit.end;
    }
    text += &source[at..];
    Rewritten { text, mutants, listed, next }
}

/// An entry of the list: file, name and function of an equation.
pub(crate) type Entry = [String; 3];

/// The entries that a file makes by `equation!`.
pub(crate) fn entries(source: &str) -> Vec<Entry> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let of = |rest: &str| {
        let arguments = rest.split_once(')')?.0;
        let mut quoted = arguments.split('"').skip(1).step_by(2);
        let function = arguments.rsplit(',').map(str::trim).find(|part| !part.is_empty())?;
        Some([quoted.next()?.to_string(), quoted.next()?.to_string(), function.to_string()])
    };
    code.split("equation!(").skip(1).filter_map(of).collect()
}

struct Edit {
    start: usize,
    end: usize,
    /// Text that opens comes after text that closes at the same place.
    opens: bool,
    order: usize,
    text: String,
}

struct Rewriter<'a> {
    kind: Kind,
    file: &'a str,
    source: &'a str,
    digest: &'a str,
    dropped: &'a BTreeSet<String>,
    first: u32,
    next: u32,
    function: Vec<String>,
    entries: &'a [Entry],
    edits: Vec<Edit>,
    mutants: Vec<Mutant>,
    listed: Vec<Listed>,
}

type Range = std::ops::Range<usize>;

fn range(node: &impl Spanned) -> Range {
    node.span().byte_range()
}

impl Rewriter<'_> {
    fn edit(&mut self, at: Range, opens: bool, text: String) {
        let order = self.edits.len();
        self.edits.push(Edit { start: at.start, end: at.end, opens, order, text });
    }

    fn written(&self, at: Range) -> String {
        self.source[at].split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// The name between runs of the mutant with a number.
    fn key(&self, id: u32) -> String {
        format!("{}.{}", self.digest, id - self.first)
    }

    /// Whether one of the next mutants compiles; if none does, what is written stays as it is.
    fn any_compiles(&mut self, count: usize) -> bool {
        let numbers = self.next..self.next + count as u32;
        let any = numbers.clone().any(|id| !self.dropped.contains(&self.key(id)));
        if !any {
            self.next = numbers.end;
        }
        any
    }

    /// Lists the next mutant, unless it does not compile; its number.
    fn list(&mut self, at: Range, mutant: &str) -> Option<u32> {
        let id = self.next;
        self.next += 1;
        let key = self.key(id);
        if self.dropped.contains(&key) {
            return None;
        }
        self.mutants.push(Mutant {
            id,
            key,
            part: self.kind.part(),
            file: self.file.into(),
            line: self.source[..at.start].lines().count().max(1),
            function: self.function.last().cloned().unwrap_or_default(),
            change: format!("`{}`: {mutant}", self.written(at)),
        });
        Some(id)
    }

    /// The branches of a choice: `if on(1) { … } else { … }`, one line for each mutant.
    fn choice(&mut self, at: Range, mutants: &[String], original: &str) -> String {
        let mut text = String::from("\n");
        for mutant in mutants {
            if let Some(id) = self.list(at.clone(), mutant) {
                text += &format!("if crate::mutants::on({id}) {{ {mutant} }} else /*M{id}*/\n");
            }
        }
        text + &format!("{{ {original} }}\n")
    }

    /// A choice between functions of two operands `l` and `r`, taken `by` value or reference.
    fn operands(&mut self, whole: Range, [left, right]: [&Expr; 2], by: &str, mutants: &[String], original: &str) {
        if !self.any_compiles(mutants.len()) {
            self.visit_expr(left);
            return self.visit_expr(right);
        }
        self.edit(whole.start..range(left).start, true, format!("({{ let (l, r) = ({by}("));
        self.visit_expr(left);
        self.edit(range(left).end..range(right).start, false, format!("), {by}("));
        self.visit_expr(right);
        let choice = self.choice(whole.clone(), mutants, original);
        self.edit(range(right).end..whole.end, false, format!(")); {choice} }})"));
    }

    /// A choice between functions of one operand `l`.
    fn operand(&mut self, whole: Range, inner: &Expr, mutants: &[String], original: &str) {
        if !self.any_compiles(mutants.len()) {
            return self.visit_expr(inner);
        }
        self.edit(whole.start..range(inner).start, true, "({ let l = (".into());
        self.visit_expr(inner);
        let choice = self.choice(whole.clone(), mutants, original);
        self.edit(range(inner).end..whole.end, false, format!("); {choice} }})"));
    }

    /// A condition or a call with a text before and after, in which `ON` is whether the mutant is active.
    fn around(&mut self, inner: &Expr, mutant: &str, [before, after]: [&str; 2]) {
        let at = range(inner);
        let Some(id) = self.list(at.clone(), mutant) else { return self.visit_expr(inner) };
        let before = before.replace("ON", &format!("crate::mutants::on({id})"));
        self.edit(at.start..at.start, true, format!("\n{before} /*M{id}*/\n"));
        self.visit_expr(inner);
        self.edit(at.end..at.end, false, after.into());
    }

    /// What only the engine does with two operands.
    fn conditions_and_assignments(&mut self, binary: &ExprBinary) {
        let around = match binary.op {
            BinOp::And(_) => ["(ON || (", "))"],
            BinOp::Or(_) => ["(!ON && (", "))"],
            BinOp::AddAssign(_) => return self.assignment(binary, &["-=", "="]),
            BinOp::SubAssign(_) => return self.assignment(binary, &["+="]),
            BinOp::MulAssign(_) => return self.assignment(binary, &["/="]),
            BinOp::DivAssign(_) => return self.assignment(binary, &["*="]),
            BinOp::BitAndAssign(_) | BinOp::BitOrAssign(_) => return self.assignment(binary, &[]),
            _ => return visit::visit_expr_binary(self, binary),
        };
        for term in [&*binary.left, &*binary.right] {
            let is_joined = |op| matches!(op, BinOp::And(_) | BinOp::Or(_));
            match term {
                Expr::Let(_) => self.visit_expr(term),
                Expr::Binary(inner) if is_joined(inner.op) => self.visit_expr(term),
                _ => self.around(term, "left out", around),
            }
        }
    }

    /// An assignment `place op= r`.
    fn assignment(&mut self, binary: &ExprBinary, others: &[&str]) {
        if !self.any_compiles(others.len() + 1) {
            return self.visit_expr(&binary.right);
        }
        let (whole, right, op) = (range(binary), range(&binary.right), self.written(range(&binary.op)));
        let place = self.source[range(&binary.left)].to_string();
        let mutants: Vec<String> = others.iter().map(|op| format!("{place} {op} r")).chain([String::new()]).collect();
        self.edit(whole.start..right.start, true, "{ let r = (".into());
        self.visit_expr(&binary.right);
        let choice = self.choice(whole.clone(), &mutants, &format!("{place} {op} r"));
        self.edit(right.end..whole.end, false, format!("); {choice} }}"));
    }
}

/// Functions that only list or describe are changed by no mutant.
const LISTS: [&str; 4] = ["equations", "paper", "papers", "names"];

impl<'ast> Visit<'ast> for Rewriter<'_> {
    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        if !module.attrs.iter().any(|attribute| attribute.path().is_ident("cfg")) {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        let name = item.sig.ident.to_string();
        if item.sig.constness.is_some() || LISTS.contains(&name.as_str()) {
            return;
        }
        self.function.push(name.clone());
        let entry = self.entries.iter().find(|[file, _, function]| file == self.file && *function == name);
        let block = range(&item.block);
        if let Some(id) = entry.filter(|_| self.kind == Kind::Scaled).map(|entry| entry[1].clone()) {
            let first = self.next;
            self.next += 3;
            let generic = item.sig.generics.type_params().next().expect("a number").ident.to_string();
            self.edit(block.start..block.start, true, format!("{{ crate::mutants::result::<{generic}, _>({first}, "));
            self.edit(block.end..block.end, false, ") }".into());
            self.listed.push(Listed { id, function: name, file: self.file.into(), laws: laws(&item.attrs), first });
        }
        if self.kind != Kind::Scaled {
            self.visit_block(&item.block);
        }
        self.function.pop();
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if item.sig.constness.is_some() || LISTS.contains(&item.sig.ident.to_string().as_str()) {
            return;
        }
        self.function.push(item.sig.ident.to_string());
        if self.kind != Kind::Scaled {
            self.visit_block(&item.block);
        }
        self.function.pop();
    }

    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'ast syn::TraitItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
    fn visit_path(&mut self, _: &'ast syn::Path) {}
    fn visit_expr_repeat(&mut self, _: &'ast syn::ExprRepeat) {}
    fn visit_stmt_macro(&mut self, _: &'ast syn::StmtMacro) {}

    fn visit_expr_binary(&mut self, binary: &'ast ExprBinary) {
        let others: &[&str] = match binary.op {
            BinOp::Add(_) => &["-", "*"],
            BinOp::Sub(_) => &["+"],
            BinOp::Mul(_) => &["/", "+"],
            BinOp::Div(_) => &["*"],
            BinOp::BitAnd(_) => &["|"],
            BinOp::BitOr(_) => &["&"],
            BinOp::Lt(_) => &["<=", ">="],
            BinOp::Le(_) => &["<", ">"],
            BinOp::Gt(_) => &[">=", "<="],
            BinOp::Ge(_) => &[">", "<"],
            BinOp::Eq(_) => &["!="],
            BinOp::Ne(_) => &["=="],
            _ if self.kind == Kind::Engine => return self.conditions_and_assignments(binary),
            _ => return visit::visit_expr_binary(self, binary),
        };
        let op = self.written(range(&binary.op));
        let mutants: Vec<String> = others.iter().map(|other| format!("l {other} r")).collect();
        // what the engine compares is not always copied
        let by = if self.kind == Kind::Engine && op.starts_with(['<', '>', '=', '!']) { "&" } else { "" };
        self.operands(range(binary), [&binary.left, &binary.right], by, &mutants, &format!("l {op} r"));
    }

    fn visit_expr_if(&mut self, branches: &'ast ExprIf) {
        use Expr::{Call, Field, Index, Macro, MethodCall, Path};
        let is_plain = matches!(*branches.cond, Call(_) | Field(_) | Index(_) | Macro(_) | MethodCall(_) | Path(_));
        if self.kind == Kind::Engine && is_plain {
            self.around(&branches.cond, "the contrary", ["(ON != (", "))"]);
        } else {
            self.visit_expr(&branches.cond);
        }
        self.visit_block(&branches.then_branch);
        if let Some((_, otherwise)) = &branches.else_branch {
            self.visit_expr(otherwise);
        }
    }

    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        match statement {
            Stmt::Expr(call @ (Expr::Call(_) | Expr::MethodCall(_) | Expr::Assign(_) | Expr::Try(_)), Some(_))
                if self.kind == Kind::Engine =>
            {
                self.around(call, "left out", ["if !ON {", "; }"]);
            }
            _ => visit::visit_stmt(self, statement),
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        self.function.push(item.sig.ident.to_string());
        visit::visit_trait_item_fn(self, item);
        self.function.pop();
    }

    fn visit_expr_unary(&mut self, unary: &'ast ExprUnary) {
        if matches!(unary.op, UnOp::Deref(_)) || matches!(*unary.expr, Expr::Lit(_)) {
            return visit::visit_expr_unary(self, unary);
        }
        let op = self.written(range(&unary.op));
        self.operand(range(unary), &unary.expr, &["l".into()], &format!("{op}l"));
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        let method = call.method.to_string();
        let changes: &[&str] = match (method.as_str(), call.args.len()) {
            ("lt", 1) => &["l.le(r)", "l.ge(r)"],
            ("le", 1) => &["l.lt(r)", "l.gt(r)"],
            ("gt", 1) => &["l.ge(r)", "l.le(r)"],
            ("ge", 1) => &["l.gt(r)", "l.lt(r)"],
            ("min", 1) => &["l.max(r)", "l"],
            ("max", 1) => &["l.min(r)", "l"],
            ("cross", 1) => &["r.cross(l)"],
            ("perpendicular_to", 1) => &["l"],
            ("sin", 0) => &["l.cos()"],
            ("cos", 0) => &["l.sin()"],
            ("abs" | "sqrt" | "squared" | "floor" | "exp" | "ln" | "tanh", 0) => &["l"],
            _ => return visit::visit_expr_method_call(self, call),
        };
        let changes: Vec<String> = changes.iter().map(ToString::to_string).collect();
        match call.args.first() {
            Some(argument) => {
                let operands = [&*call.receiver, argument];
                self.operands(range(call), operands, "", &changes, &format!("l.{method}(r)"));
            }
            None => self.operand(range(call), &call.receiver, &changes, &format!("l.{method}()")),
        }
    }

    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        let function = self.written(range(&call.func));
        let constant = match (function.as_str(), call.args.len()) {
            ("R::one", 0) => Some("R::lit(2.0)"),
            ("R::zero", 0) => Some("R::one()"),
            ("R::pi", 0) => Some("R::lit(3.0)"),
            _ => None,
        };
        if let Some(constant) = constant {
            if !self.any_compiles(1) {
                return;
            }
            let choice = self.choice(range(call), &[constant.into()], &format!("{function}()"));
            self.edit(range(call), true, format!("({choice})"));
        } else if function.ends_with("::select") && call.args.len() == 3 && self.any_compiles(2) {
            let (first, last) = (range(&call.args[0]), range(&call.args[2]));
            self.edit(range(call).start..first.start, true, "({ let (m, l, r) = (".into());
            call.args.iter().for_each(|argument| self.visit_expr(argument));
            let choice = self.choice(range(call), &["l".into(), "r".into()], &format!("{function}(m, l, r)"));
            self.edit(last.end..range(call).end, false, format!("); {choice} }})"));
        } else {
            visit::visit_expr_call(self, call);
        }
    }

    fn visit_expr_lit(&mut self, literal: &'ast ExprLit) {
        let other = match &literal.lit {
            Lit::Float(number) => number.base10_parse::<f64>().map(|x| format!("{:?}{}", x + 1.0, number.suffix())),
            Lit::Int(number) => number.base10_parse::<u64>().map(|x| format!("{}{}", x + 1, number.suffix())),
            _ => return,
        };
        if !self.any_compiles(1) {
            return;
        }
        let at = range(literal);
        let original = self.written(at.clone());
        let choice = self.choice(at.clone(), &[other.expect("a number")], &original);
        self.edit(at, true, format!("({choice})"));
    }
}

/// The laws that a documentation lists.
fn laws(attributes: &[syn::Attribute]) -> Vec<String> {
    let line = |attribute: &syn::Attribute| match &attribute.meta {
        syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value().trim().to_string()),
            _ => None,
        },
        _ => None,
    };
    let lines = attributes.iter().filter_map(line).skip_while(|line| line != "# Laws").skip(1);
    lines.filter_map(|line| Some(line.strip_prefix("* `")?.split('`').next()?.to_string())).collect()
}
