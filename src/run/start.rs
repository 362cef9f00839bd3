//! From a case to the run of its paper.

use super::{Control, Glance, Run, Study, soot, titania, wear};
use crate::case::{Amorphous, Case, Model, Sample, SootStage, Torsion, located};
use crate::error::{AtPath, Error};
use crate::output::{Finding, Manifest, RunFolder, Status, sha256_file, write_atomically};
use crate::spec::Necked;
use crate::spec::soot::{Along, Printed, Programmed};
use crate::spec::titania::Tabulated;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Does the same with the plan of any paper.
macro_rules! with_plan {
    ($case:expr, $plan:ident => $done:expr) => {
        match &$case.model {
            Model::Wear(_) => {
                let $plan = wear::Plan::of(&$case);
                $done
            }
            Model::Soot(model) => match model.torsion {
                Torsion::Spring => {
                    let $plan = soot::Plan::of(&$case, Along);
                    $done
                }
                Torsion::AsPrinted => {
                    let $plan = soot::Plan::of(&$case, Printed);
                    $done
                }
                Torsion::AsPublished => {
                    let $plan = soot::Plan::of(&$case, Programmed);
                    $done
                }
            },
            Model::Titania(model) if $case.is_about_a_film() && model.neck_springs.is_some() => {
                let $plan = titania::Film::<Necked<Tabulated>>::of(&$case);
                $done
            }
            Model::Titania(_) if $case.is_about_a_film() => {
                let $plan = titania::Film::<Tabulated>::of(&$case);
                $done
            }
            Model::Titania(_) => {
                let $plan = titania::Plan::of(&$case);
                $done
            }
        }
    };
}

/// Makes a run folder for the case of a file, and goes from the beginning to the end; `show` is told how it is doing.
pub fn launch(
    file: &Path,
    root: &Path,
    replace: bool,
    control: &Control,
    show: &mut dyn FnMut(Glance),
) -> Result<(RunFolder, Vec<Finding>), Error> {
    let (case, text) = Case::read(file)?;
    let mut inputs = BTreeMap::new();
    for file in files(&case)? {
        inputs.insert(file.display().to_string(), sha256_file(&file)?);
    }
    // Whatever is wrong with the input is found before anything is written.
    saves(&case, root).map_err(|error| located(error, file, &text))?;
    let initial = with_plan!(case, plan => plan.initial()).map_err(|error| located(error, file, &text))?;
    let folder = RunFolder::create(root, replace)?;
    write_atomically(&folder.case(), text.as_bytes())?;
    write_atomically(&folder.resolved(), case.resolved().as_bytes())?;
    // Of the copy: a case that comes through a pipe can be read only once.
    inputs.insert(file.display().to_string(), sha256_file(&folder.case())?);
    let manifest = Manifest::begin(case.seed, inputs);
    let findings = with_plan!(case, plan => Run::new(&case, plan, &folder, manifest, control, show).start(initial)?);
    Ok((folder, findings))
}

/// The files that a case reads, all of which are there.
fn files(case: &Case) -> Result<Vec<PathBuf>, Error> {
    let sample = match &case.sample {
        Sample::Amorphous(Amorphous { load, .. }) => load.clone(),
        Sample::Film(film) => film.load.clone(),
        _ => None,
    };
    let files: Vec<PathBuf> = sample.into_iter().chain(case.soot_files()).collect();
    files.iter().try_for_each(|file| is_there(file))?;
    Ok(files)
}

fn is_there(file: &Path) -> Result<(), Error> {
    std::fs::metadata(file).map(drop).map_err(|cause| Error::NoInput(file.into(), cause))
}

/// Whether the folders are there that a case keeps samples in, or will be with the run.
fn saves(case: &Case, root: &Path) -> Result<(), Error> {
    let mut found = match &case.sample {
        Sample::Amorphous(Amorphous { save, .. }) => vec![("sample.amorphous".to_string(), save.clone())],
        Sample::Film(film) => vec![("sample.film".to_string(), film.save.clone())],
        _ => Vec::new(),
    };
    for (number, stage) in case.soot().map(|soot| soot.2).unwrap_or_default().iter().enumerate() {
        if let SootStage::Deposition(deposition) = stage {
            found.push((case.soot_key(number, stage), deposition.save.clone()));
        }
    }
    for (section, file) in found.into_iter().filter_map(|(section, file)| Some((section, file?))) {
        // That of a mere name is empty.
        let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
        if folder.is_some_and(|folder| !folder.is_dir() && !root.ancestors().any(|of_run| of_run == folder)) {
            let what = format!("found `{}`, expected a file in a folder that exists", file.display());
            return Err(Error::of_key(format!("{section}.save"), what));
        }
    }
    Ok(())
}

/// Looks at everything about the case of a file short of running it.
pub fn examine(file: &Path) -> Result<Case, Error> {
    let (case, text) = Case::read(file)?;
    files(&case)?;
    saves(&case, &Path::new("run").join(file.file_stem().unwrap_or_default()))
        .map_err(|error| located(error, file, &text))?;
    with_plan!(case, plan => plan.examine()).map_err(|error| located(error, file, &text))?;
    Ok(case)
}

/// Runs the case of a file in a folder, or goes on with it there, unless it has finished; says whether
/// there was anything left to do.
pub fn complete(file: &Path, root: &Path, control: &Control) -> Result<bool, Error> {
    let (case, text) = Case::read(file)?;
    // One that was killed before its first checkpoint begins again.
    let replace = !RunFolder::clear(root)?;
    if replace {
        let what = "is not a run that can be gone on with; remove this folder to begin anew";
        let strange = |_| Error::Usage(format!("{}: {what}", root.display()));
        let folder = RunFolder::open(root).map_err(strange)?;
        let manifest = Manifest::read(&folder).map_err(strange)?;
        if std::fs::read_to_string(folder.case()).at(&folder.case())? != text {
            return Err(Error::Usage("its run folder holds another case".into()));
        }
        if manifest.status == Status::Finished {
            return Ok(false);
        }
        if !folder.checkpoints().is_empty()? {
            return resume(&case, &folder, manifest, control, &mut |_| {}).map(|_| true);
        }
    }
    launch(file, root, replace, control, &mut |_| {}).map(|_| true)
}

/// Goes on with a run from its latest checkpoint. Its case must be the one that it was begun with.
pub fn resume(
    case: &Case,
    folder: &RunFolder,
    manifest: Manifest,
    control: &Control,
    show: &mut dyn FnMut(Glance),
) -> Result<Vec<Finding>, Error> {
    let begun_with = sha256_file(&folder.case())?;
    if !manifest.inputs.values().any(|input| *input == begun_with) {
        return Err(Error::input(&folder.case(), "has changed since the run was begun"));
    }
    with_plan!(*case, plan => Run::new(case, plan, folder, manifest, control, show).resume())
}

/// Whether the files that come after a stage are those that the run was begun with; those that came before are in its checkpoint.
pub(super) fn unchanged_after(stage: usize, case: &Case, manifest: &Manifest) -> Result<(), Error> {
    let stages = case.soot().map(|soot| soot.2).unwrap_or_default();
    for file in stages.iter().skip(stage + 1).filter_map(|stage| stage.solid().map(|solid| &solid.stl)) {
        is_there(file)?;
        let hash = sha256_file(file)?;
        if manifest.inputs.get(&file.display().to_string()) != Some(&hash) {
            return Err(Error::input(file, "has changed since the run was begun"));
        }
    }
    Ok(())
}
