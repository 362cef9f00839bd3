//! Which function calls which: read from the syntax of the sources, with names resolved through what a module imports.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{Expr, ExprCall, ExprPath, Item, Token, UseTree};

/// A module, or something in it: `spec`, `mechanics`, `sphere`, `sphere_mass`.
type Names = Vec<String>;

/// A function calls another, or hands it over.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Call {
    /// The file of the caller, below the repository.
    pub file: PathBuf,
    /// The function that calls.
    pub function: String,
    /// What is called: modules and function.
    to: Names,
}

/// All calls in some sources.
pub struct Calls {
    calls: BTreeSet<Call>,
}

impl Calls {
    /// The calls in sources, paths below the repository with their texts. What is for tests only is left out.
    ///
    /// # Errors
    ///
    /// If a text is no Rust.
    pub fn of(sources: &[(PathBuf, String)]) -> Result<Self, String> {
        let (mut modules, mut calls, mut tests) = (BTreeMap::new(), vec![], vec![]);
        for (file, text) in sources {
            let tree = syn::parse_file(text).map_err(|error| format!("{}: {error}", file.display()))?;
            let mut reader = Reader::new(file);
            reader.visit_file(&tree);
            tests.extend(reader.tests);
            // library and program are one module
            modules.entry(reader.module).or_insert_with(BTreeMap::new).extend(reader.imports);
            calls.extend(reader.calls.into_iter().map(|(function, to)| (file, function, to)));
        }
        let for_tests = |file: &Path| tests.iter().any(|module| module_of(file).starts_with(module));
        let calls = calls.into_iter().filter(|(file, ..)| !for_tests(file)).map(|(file, function, to)| Call {
            file: file.clone(),
            function,
            to: resolved(to, &modules),
        });
        Ok(Self { calls: calls.collect() })
    }

    /// The calls of a function of a file of the specification, by others than itself.
    pub fn to<'a>(&'a self, file: &str, function: &str) -> impl Iterator<Item = &'a Call> {
        let path = Path::new("spec").join(file);
        let (mut to, own) = (module_of(&path), (path, function.to_string()));
        to.push(function.into());
        self.calls.iter().filter(move |call| call.to == to && (&call.file, &call.function) != (&own.0, &own.1))
    }
}

/// The module that a file is.
fn module_of(file: &Path) -> Names {
    let parts = file.with_extension("");
    let parts = parts.iter().map(|part| part.to_string_lossy().into_owned());
    parts.filter(|part| !["lib", "mod", "main"].contains(&part.as_str())).collect()
}

/// A path in which each name that a module imports is replaced by what it stands for.
fn resolved(mut path: Names, modules: &BTreeMap<Names, BTreeMap<String, Names>>) -> Names {
    // a name may stand for another; none is imported through more modules than this
    for _ in 0..8 {
        // the innermost module first: a function may have the name of its module
        let stands_for =
            (1..path.len()).rev().find_map(|at| Some((at, modules.get(&path[..at])?.get(&path[at])?.clone())));
        match stands_for {
            Some((at, target)) if target[..] != path[..=at] => path = [&target[..], &path[at + 1..]].concat(),
            _ => break,
        }
    }
    path
}

/// Reads one file.
struct Reader {
    module: Names,
    function: Vec<String>,
    imports: BTreeMap<String, Names>,
    calls: Vec<(String, Names)>,
    /// Modules for tests only, in files of their own.
    tests: Vec<Names>,
}

impl Reader {
    fn new(file: &Path) -> Self {
        Self { module: module_of(file), function: vec![], imports: BTreeMap::new(), calls: vec![], tests: vec![] }
    }

    /// A path from the root of all sources.
    fn absolute(&self, path: &[String]) -> Names {
        let mut from = self.module.clone();
        let mut rest = path;
        match path[0].as_str() {
            "crate" => (from, rest) = (self.module[..1].to_vec(), &path[1..]),
            "self" => rest = &path[1..],
            "veridem_spec" => (from, rest) = (vec!["spec".into()], &path[1..]),
            _ => {}
        }
        while rest.first().is_some_and(|part| part == "super") {
            from.pop();
            rest = &rest[1..];
        }
        [from, rest.to_vec()].concat()
    }

    fn import(&mut self, tree: &UseTree, before: &[String]) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            UseTree::Path(path) => self.import(&path.tree, &with(&path.ident)),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.import(tree, before)),
            UseTree::Name(name) if name.ident == "self" => {
                let last = before.last().expect("a module").clone();
                self.imports.insert(last, self.absolute(before));
            }
            UseTree::Name(name) => drop(self.imports.insert(name.ident.to_string(), self.absolute(&with(&name.ident)))),
            UseTree::Rename(new) => drop(self.imports.insert(new.rename.to_string(), self.absolute(&with(&new.ident)))),
            UseTree::Glob(_) => {}
        }
    }

    fn call(&mut self, path: &ExprPath) {
        let names: Names = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let function = self.function.last().cloned().unwrap_or_default();
        self.calls.push((function, self.absolute(&names)));
    }
}

fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        _ => false,
    })
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes = match item {
            Item::Fn(item) => &item.attrs,
            Item::Impl(item) => &item.attrs,
            Item::Mod(item) => &item.attrs,
            Item::Use(item) => &item.attrs,
            _ => return visit::visit_item(self, item),
        };
        match item {
            Item::Mod(module) if is_for_tests(attributes) => {
                self.tests.push(self.absolute(&["self".into(), module.ident.to_string()]));
            }
            _ if is_for_tests(attributes) => {}
            _ => visit::visit_item(self, item),
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.import(&item.tree, &[]);
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.function.push(item.sig.ident.to_string());
        visit::visit_item_fn(self, item);
        self.function.pop();
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.function.push(item.sig.ident.to_string());
        visit::visit_impl_item_fn(self, item);
        self.function.pop();
    }

    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        match &*call.func {
            Expr::Path(path) => self.call(path),
            other => self.visit_expr(other),
        }
        call.args.iter().for_each(|argument| self.visit_expr(argument));
    }

    /// A function that is handed over, unless it is a variable.
    fn visit_expr_path(&mut self, path: &'ast ExprPath) {
        let imported = |name: &syn::Ident| self.imports.contains_key(&name.to_string());
        if path.path.segments.len() > 1 || path.path.get_ident().is_some_and(imported) {
            self.call(path);
        }
    }

    /// The arguments of a macro, where they are expressions; the list of equations calls none of them.
    fn visit_macro(&mut self, item: &'ast syn::Macro) {
        if item.path.is_ident("equation") {
            return;
        }
        let expressions = item.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated);
        expressions.into_iter().flatten().for_each(|expression| <Self as Visit<'_>>::visit_expr(self, &expression));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn callers(texts: &[(&str, &str)], file: &str, function: &str) -> Vec<String> {
        let sources: Vec<_> = texts.iter().map(|(path, text)| (PathBuf::from(path), text.to_string())).collect();
        let calls = Calls::of(&sources).unwrap();
        calls.to(file, function).map(|call| format!("{} {}", call.file.display(), call.function)).collect()
    }

    #[test]
    fn a_call_is_found_whatever_the_name_is_imported_through() {
        let texts = [
            ("spec/wear/mod.rs", "pub use crate::mechanics::sphere as eq17;"),
            ("src/a.rs", "use crate::spec::wear::eq17; fn a() { eq17::mass(1.0); }"),
            ("src/b.rs", "use veridem_spec::mechanics::{self, sphere::mass as m}; fn b() { [1.0].map(m); }"),
            ("src/c.rs", "fn c() { println!(\"{}\", crate::spec::mechanics::sphere::mass(1.0)); }"),
            ("src/lib.rs", "pub use veridem_spec as spec;"),
            ("src/join/mod.rs", "mod join; use join::join;"),
            ("src/join/join.rs", "use crate::spec::mechanics::sphere::mass; fn join() { mass(1.0); }"),
            ("spec/mechanics/sphere.rs", "fn mass(x: f64) -> f64 { x } fn twice() { mass(2.0); }"),
        ];
        let found = callers(&texts, "mechanics/sphere.rs", "mass");
        let expected =
            ["spec/mechanics/sphere.rs twice", "src/a.rs a", "src/b.rs b", "src/c.rs c", "src/join/join.rs join"];
        assert_eq!(found, expected);
    }

    #[test]
    fn a_module_a_word_and_a_test_call_nothing() {
        let texts = [
            ("spec/titania/law.rs", "use super::attraction::Attraction; fn law() { Attraction::new(attraction); }"),
            ("spec/titania/words.rs", "// attraction(1.0)\nfn words() { \"attraction(1.0)\"; }"),
            ("spec/titania/tests.rs", "#[cfg(test)] mod laws { fn law() { super::super::eq03::attraction(1.0); } }"),
            ("spec/titania/list.rs", "fn equations() { equation!(\"a\", \"b\", [], super::eq03::attraction); }"),
        ];
        assert_eq!(callers(&texts, "titania/eq03.rs", "attraction"), Vec::<String>::new());
    }
}
