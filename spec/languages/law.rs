//! A contact law as procedures: the constants of a pair, and its forces in a step.

use super::{Exported, Row};
use crate::equation::{Laid, Taken};
use crate::numbers::source::{Graph, Source};
use crate::{Contact, Flat, Named, PairModel, Vec3};

/// The procedures of a contact law with its parameters: one for the constants of a pair of spheres, one for its forces, springs and losses in a step. All
/// quantities are in the units of the parameters. `title` says which law it is, with which parameters.
pub fn law<M: PairModel>(model: &M, id: &str, title: &str) -> [Exported; 2]
where
    M::Coefficients<Source>: Named<Source>,
{
    let row = |name: &str, size: usize, unit: &str, domain: &str, meaning: String| {
        let (unit, domain) = (unit.into(), domain.into());
        Row { name: name.into(), size, unit, domain, meaning }
    };
    let radii = || {
        [("r_i", "radius of i"), ("r_j", "radius of j")].map(|(name, meaning)| row(name, 1, "m", "> 0", meaning.into()))
    };
    let masses =
        [("m_i", "mass of i"), ("m_j", "mass of j")].map(|(name, meaning)| row(name, 1, "kg", "> 0", meaning.into()));
    let names = <M::Coefficients<Source>>::names().join(", ");
    let constants = |domain: &str| {
        row("constants", <M::Coefficients<Source>>::LEN, "SI", domain, format!("constants of the pair: {names}"))
    };
    let springs = |meaning: &str| row("springs", <M::Memory<Source>>::LEN, "m", "any", meaning.into());
    let vector = |name: &str, unit: &str, meaning: &str| row(name, 3, unit, "any", meaning.into());
    let losses = <M::Losses<Source>>::names().join(", ");
    let procedure_name = id.replace('-', "_");

    let of_pair = Exported {
        id: id.into(),
        name: format!("{procedure_name}_constants"),
        title: format!("{id}: constants of a pair for {procedure_name}. {title}"),
        arguments: radii().into_iter().chain(masses).collect(),
        results: vec![constants("")],
        graph: Graph::of(4, |x| {
            let constants = model.coefficients(x[0], x[1], x[2], x[3]);
            (0..<M::Coefficients<Source>>::LEN).map(|k| *constants.at(k)).collect()
        }),
    };
    let mut arguments = vec![
        vector("x", "m", "position of i minus position of j"),
        vector("v", "m/s", "velocity of i minus velocity of j"),
        vector("omega_i", "rad/s", "angular velocity of i"),
        vector("omega_j", "rad/s", "angular velocity of j"),
    ];
    arguments.extend(radii());
    arguments.extend([constants("any"), springs("springs of the contact, zero for a new one")]);
    arguments.push(row("dt", 1, "s", "> 0", "time step".into()));
    let results = vec![
        vector("force", "N", "force on i, its negative on j"),
        vector("torque_i", "N m", "torque on i about its centre"),
        vector("torque_j", "N m", "torque on j about its centre"),
        springs("springs for the next step"),
        row("losses", <M::Losses<Source>>::LEN, "J", "any", format!("energy lost in the step: {losses}")),
    ];
    let graph = Graph::of(arguments.iter().map(|row| row.size).sum(), |numbers| step(model, numbers));
    let title = format!("{id}: forces of a pair in a step. {title}");
    [of_pair, Exported { id: id.into(), name: procedure_name, title, arguments, results, graph }]
}

/// The pair after a step, all numbers laid end to end.
fn step<M: PairModel>(model: &M, numbers: &[Source]) -> Vec<Source> {
    let mut rest = numbers.iter().copied();
    let mut next = || rest.next().expect("a number for each argument");
    let [x, v, omega_i, omega_j] = std::array::from_fn(|_| Vec3::take(&mut next));
    let contact = Contact::new(x, v, omega_i, omega_j, next(), next());
    let constants = Flat::from_fn(|_| next());
    let springs = Flat::from_fn(|_| next());
    let outcome = model.pair(&contact, &constants, springs, next());
    let mut out = vec![];
    let wrench = outcome.wrench;
    (wrench.force, wrench.torque_i, wrench.torque_j).put(&mut |number| out.push(number));
    out.extend((0..<M::Memory<Source>>::LEN).map(|k| *outcome.memory.at(k)));
    out.extend((0..<M::Losses<Source>>::LEN).map(|k| *outcome.losses.at(k)));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::titania::Titania;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn a_law_has_the_bits_of_its_model(gap in -0.6e-9..1e-9, motion in prop::array::uniform9(-9.0..9.0f64), spring in -1e-10..1e-10) {
            let (model, r, m, dt) = (Titania::paper(1e-9, 1e-9, 1e-9), [2e-9, 3e-9], [1e-22, 4e-22], 1e-14);
            let [constants, forces] = law(&model, "titania-law", "");
            let x = Vec3([0.6, 0.0, 0.8]) * (r[0] + r[1] + gap);
            let [v, omega_i, omega_j] = [0, 3, 6].map(|k| Vec3([motion[k], motion[k + 1], motion[k + 2]]));
            let (omega_i, omega_j) = (omega_i * 1e9, omega_j * 1e9);
            let spring = Vec3([0.8 * spring, spring, -0.6 * spring]);

            let of_pair = constants.graph.evaluate(&[r[0], r[1], m[0], m[1]]);
            let given = [x.0, v.0, omega_i.0, omega_j.0].concat();
            let given = [&given[..], &r, &of_pair, &spring.0, &[dt]].concat();
            let recorded = forces.graph.evaluate(&given);

            let contact = Contact::new(x, v, omega_i, omega_j, r[0], r[1]);
            let outcome = model.pair(&contact, &model.coefficients(r[0], r[1], m[0], m[1]), spring, dt);
            let mut expected = vec![];
            (outcome.wrench.force, outcome.wrench.torque_i, outcome.wrench.torque_j).put(&mut |number| expected.push(number));
            expected.extend(outcome.memory.0);
            expected.extend((0..4).map(|k| *outcome.losses.at(k)));
            prop_assert_eq!(recorded.iter().map(|y| y.to_bits()).collect::<Vec<_>>(), expected.iter().map(|y| y.to_bits()).collect::<Vec<_>>());
            prop_assert_eq!(recorded.len(), forces.results.iter().map(|row| row.size).sum::<usize>());
        }
    }
}
