// SPDX-License-Identifier: MIT
//! Writes the trace of a rasterizer. What is wrong, or cannot be written, is an error.
//!     let mut trace = Trace::new("mine.jsonl", 17, 14, "center", r#","title":"Mine","method":{"fill":"scanline"}"#)?;
//!     step!(trace, "pixel", x = -1, y = 2)?; // ... trace.end()?;
use std::{collections::BTreeMap, fs::File, io::{BufWriter, Error, ErrorKind, Result, Write}};
const NEEDED: &str = "triangulate name,matrix name,vertex name space,face dot,primitive kind name,light intensity,\
clip plane,edge edge,half half,ray x y,crossings y,skip why,pixel x y,sample x y,scanline y left right from to,\
along value pixel,decide x y d move,depth x y depth,reject why";
pub trait Json { fn json(&self) -> String; }
impl Json for i64 { fn json(&self) -> String { self.to_string() } }
impl Json for f64 { fn json(&self) -> String { if self.is_finite() { format!("{:?}", self + 0.0) } else { format!("\"{self}\"") } } }
impl Json for str { fn json(&self) -> String { format!("\"{}\"", self.chars().map(|c| if c < ' ' || c == '"' || c == '\\' {
    format!("\\u{:04x}", c as u32) } else { c.to_string() }).collect::<String>()) } }
impl<T: Json + ?Sized> Json for &T { fn json(&self) -> String { (**self).json() } }
impl<T: Json, const N: usize> Json for [T; N] { fn json(&self) -> String { format!("[{}]", self.iter().map(T::json).collect::<Vec<_>>().join(",")) } }
#[macro_export] macro_rules! step { ($trace:expr, $kind:expr $(, $key:ident = $value:expr)*) => { $trace.step(
    $kind, &[$((stringify!($key), $crate::rastertrace_emit::Json::json(&$value))),*], file!(), line!()) } }
fn wrong(what: String) -> Result<()> { Err(Error::new(ErrorKind::InvalidInput, what)) }
pub struct Trace { file: BufWriter<File>, count: BTreeMap<String, u64>, has_ended: bool }
impl Trace {
    pub fn new(path: &str, width: u32, height: u32, origin: &str, header: &str) -> Result<Trace> {
        let mut trace = Trace { file: BufWriter::new(File::create(path)?), count: BTreeMap::new(), has_ended: false };
        writeln!(trace.file, r#"{{"rastertrace":1,"canvas":{{"width":{width},"height":{height},"origin":"{origin}"}}{header}}}"#).map(|()| trace)
    }
    pub fn step(&mut self, kind: &str, fields: &[(&str, String)], file: &str, line: u32) -> Result<()> {
        let place = format!("{}:{line}", file.rsplit(|c| c == '/' || c == '\\').next().unwrap());
        let needed = NEEDED.split(',').map(|row| row.split(' ')).find(|row| row.clone().next() == Some(kind)).into_iter().flatten();
        let missing = needed.skip(1).find(|key| fields.iter().all(|field| field.0 != *key));
        missing.or(self.has_ended.then(|| "it before the end")).map_or(Ok(()), |what| wrong(format!("{kind} in {place}: expected {what}")))?;
        *self.count.entry(kind.to_string()).or_default() += 1;
        let told: String = fields.iter().map(|(key, value)| format!(r#","{key}":{value}"#)).collect();
        writeln!(self.file, r#"{{"step":"{kind}"{told},"code":"{place}"}}"#)
    }
    pub fn end(&mut self) -> Result<()> {
        if std::mem::replace(&mut self.has_ended, true) { wrong("end: expected it once".into())? }
        writeln!(self.file, r#"{{"end":{{"steps":{},"count":{:?}}}}}"#, self.count.values().sum::<u64>(), self.count)?;
        self.file.flush()
    }
}
