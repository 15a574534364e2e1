//! `explain --json --formulas`: the formula of each term as data.

use explain::{PixelExplanation, RecordedRay};
use serde_json::{Value, json};

/// An explanation as JSON, in which each term has its formula if so asked.
pub fn json(explanation: &PixelExplanation, with_formulas: bool) -> serde_json::Result<Value> {
    let mut whole = serde_json::to_value(explanation)?;
    for (sample, data) in explanation.samples.iter().zip(list(&mut whole["samples"])) {
        if let Some(ray) = sample.ray.as_ref().filter(|_| with_formulas) {
            add(ray, &mut data["ray"]);
        }
    }
    Ok(whole)
}

/// Adds the formulas of a ray and of all rays after it.
fn add(ray: &RecordedRay, data: &mut Value) {
    for (term, data) in ray.terms.iter().zip(list(&mut data["terms"])) {
        let formula = ray.formula(term);
        let factors = formula.factors.iter().map(|factor| {
            json!({"symbol": factor.symbol, "number": factor.number, "value": factor.value, "divides": factor.divides})
        });
        data["formula"] = json!({
            "symbols": formula.symbols(),
            "numbers": formula.numbers(),
            "place": formula.place,
            "source": formula.source,
            "factors": factors.collect::<Vec<Value>>(),
        });
    }
    for (child, data) in ray.children.iter().zip(list(&mut data["children"])) {
        add(child, data);
    }
}

fn list(data: &mut Value) -> &mut [Value] {
    data.as_array_mut().map_or(&mut [], Vec::as_mut_slice)
}
