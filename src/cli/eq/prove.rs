//! Proofs on a terminal.

use crate::equations::Entry;
use crate::proofs::{Scale, Verdict, box_text, verdicts};
use serde_json::{Value, json};

/// Every claim with its status, over each box.
pub(super) fn text(entry: &Entry) -> String {
    let mut text = String::new();
    for scale in Scale::ALL {
        let of_scale: Vec<Verdict> = verdicts(entry, scale);
        text += &format!("{}, {} box\n    {}\n", entry.equation.id, scale.name(), box_text(entry, scale));
        for verdict in of_scale {
            text += &format!("  {:8}  {}\n", verdict.status().name(), verdict.sentence(entry));
            text += &format!("            {}\n", verdict.extent(entry));
        }
    }
    text
}

/// The same for programs.
pub(super) fn json(entry: &Entry) -> String {
    let all = Scale::ALL.into_iter().flat_map(|scale| {
        verdicts(entry, scale).into_iter().map(move |verdict| {
            json!({
                "box": scale.name(),
                "claim": verdict.sentence(entry),
                "status": verdict.status().name(),
                "parts": verdict.proof.parts,
                "stopped": verdict.proof.stopped.as_ref().map(|_| verdict.extent(entry)),
            })
        })
    });
    format!("{:#}\n", json!({ "id": entry.equation.id, "claims": all.collect::<Value>() }))
}
