// SPDX-License-Identifier: MIT
//! A rasterizer in Rust that tells what it decides: as triangle.c.
//!
//!     rustc -o triangle examples/foreign/triangle.rs && ./triangle triangle.jsonl

#[macro_use]
mod rastertrace_emit;
use rastertrace_emit::Trace;

const CORNERS: [(&str, f64, f64); 3] = [("A", 2.0, 5.0), ("B", -4.0, -3.0), ("C", 5.0, -3.0)]; // y points up

/// The crossings of a row with the edges: x, and the edge's name, the upper vertex first.
fn ends_of_row(y: f64) -> Vec<(f64, String)> {
    let mut ends = Vec::new();
    for i in 0..3 {
        let (one, other) = (CORNERS[i], CORNERS[(i + 1) % 3]);
        let (upper, lower) = if one.2 > other.2 { (one, other) } else { (other, one) };
        if lower.2 <= y && y <= upper.2 && lower.2 != upper.2 {
            let x = upper.1 + (upper.1 - lower.1) / (upper.2 - lower.2) * (y - upper.2);
            ends.push((x, format!("{}{}", upper.0, lower.0)));
        }
    }
    ends.sort_by(|a, b| a.partial_cmp(b).unwrap());
    ends
}

fn main() -> std::io::Result<()> {
    let path = std::env::args().nth(1).expect("the name of the trace");
    let header = r#","title":"Mine","method":{"scalar":"double","fill":"scanline","rounding":"floor"}"#;
    let mut trace = Trace::new(&path, 17, 14, "center", header)?;
    step!(trace, "primitive", kind = "triangle", name = "ABC", vertices = CORNERS.map(|corner| corner.0),
          at = CORNERS.map(|corner| [corner.1, corner.2]), color = "#000000")?;
    for y in (-3..=5).rev() {
        let ends = ends_of_row(y as f64);
        let (from, to) = (ends[0].0.floor() as i64, ends[1].0.floor() as i64);
        step!(trace, "scanline", y = y, left = ends[0].0, right = ends[1].0, from = from, to = to,
              left_edge = *ends[0].1, right_edge = *ends[1].1)?;
        for x in from..=to {
            step!(trace, "pixel", x = x, y = y)?;
        }
    }
    trace.end()
}
