//! Tables of known arms for tests.

use crate::chain::Chain;
use crate::chain::table::parse;

/// The chain of a table.
pub(crate) fn chain(table: &str) -> Chain {
    let tokens = crate::diagnostic::lex(table).unwrap_or_else(|e| panic!("{}", e.draw(table, "table")));
    let parsed = parse(tokens);
    Chain::new(parsed.spec.unwrap_or_else(|| panic!("{}", parsed.errors.draw(table, "table"))))
}

/// All but the KUKA, by name.
pub(crate) const ALL: [(&str, &str); 8] = [
    ("puma", PUMA),
    ("ur5", UR5),
    ("scara", SCARA),
    ("stanford", STANFORD),
    ("planar", PLANAR),
    ("rpr", RPR),
    ("panda", PANDA),
    ("odd", ODD),
];

pub(crate) const PUMA: &str = "
pub struct Puma560;
convention = modified;
let a2: length = 431.8mm;
let a3: length = 20.3mm;
let d3: length = 150.05mm;
let d4: length = 431.8mm;
| joint | alpha  | a  | d  | theta | range            |
|-------|--------|----|----|-------|------------------|
|   1   |   0    | 0  | 0  | q1    | -160deg..=160deg |
|   2   | -90deg | 0  | 0  | q2    | -225deg..= 45deg |
|   3   |   0    | a2 | d3 | q3    |  -45deg..=225deg |
|   4   | -90deg | a3 | d4 | q4    | -110deg..=170deg |
|   5   |  90deg | 0  | 0  | q5    | -100deg..=100deg |
|   6   | -90deg | 0  | 0  | q6    | -266deg..=266deg |
";

pub(crate) const UR5: &str = "
pub struct Ur5;
convention = standard;
| theta | d        | a        | alpha  |
|-------|----------|----------|--------|
| q1    | 0.089159 | 0        |  90deg |
| q2    | 0        | -0.425   |  0     |
| q3    | 0        | -0.39225 |  0     |
| q4    | 0.10915  | 0        |  90deg |
| q5    | 0.09465  | 0        | -90deg |
| q6    | 0.0823   | 0        |  0     |
";

pub(crate) const SCARA: &str = "
pub struct Scara;
convention = modified;
let d1: length;
let d2: length;
let a1: length;
let a2: length;
| alpha | a  | d  | theta |
|-------|----|----|-------|
| 0     | 0  | d1 | q1    |
| 0     | a1 | d2 | q2    |
| 0     | a2 | 0  | q3    |
| 0     | 0  | q4 | 0     |
";

pub(crate) const STANFORD: &str = "
pub struct Stanford;
convention = standard;
let d2: length;
| theta | d  | a | alpha  |
|-------|----|---|--------|
| q1    | 0  | 0 | -90deg |
| q2    | d2 | 0 |  90deg |
| 0     | q3 | 0 |  0     |
| q4    | 0  | 0 | -90deg |
| q5    | 0  | 0 |  90deg |
| q6    | 0  | 0 |  0     |
";

pub(crate) const PLANAR: &str = "
pub struct Planar;
convention = modified;
unit = mm;
let L1: length;
let L2: length;
let L3: length;
| alpha | a  | d | theta |
|-------|----|---|-------|
| 0     | 0  | 0 | q1    |
| 0     | L1 | 0 | q2    |
| 0     | L2 | 0 | q3    |
tool = tx(L3);
";

pub(crate) const RPR: &str = "
pub struct Rpr;
convention = modified;
let L2: length;
| alpha | a | d  | theta |
|-------|---|----|-------|
| 0     | 0 | 0  | q1    |
| 90deg | 0 | q2 | 0     |
| 0     | 0 | L2 | q3    |
";

pub(crate) const PANDA: &str = "
pub struct Panda;
convention = modified;
redundant = q7;
| alpha  | a       | d     | theta |
|--------|---------|-------|-------|
| 0      | 0       | 0.333 | q1    |
| -90deg | 0       | 0     | q2    |
| 90deg  | 0       | 0.316 | q3    |
| 90deg  | 0.0825  | 0     | q4    |
| -90deg | -0.0825 | 0.384 | q5    |
| 90deg  | 0       | 0     | q6    |
| 90deg  | 0.088   | 0.107 | q7    |
";

/// Odd twists, an angle without exact sine, offsets, a coupled drive, a base.
pub(crate) const ODD: &str = "
pub struct Odd;
convention = standard;
let beta: angle = 20deg;
let offset: length = 0.2m;
let p = 0.5;
base = tz(0.3) * ry(45deg);
| theta           | d      | a     | alpha  |
|-----------------|--------|-------|--------|
| q1 + 30deg      | 0      | 0.1   | beta   |
| q2 - q1         | 0.25   | offset| 60deg  |
| 0               | p*(q3 - q2) | 0 | beta  |
| q4 + approx 0.3rad | 0   | 0.07  | -45deg |
";

/// KUKA KR 6 R700.
pub(crate) const KUKA: &str = "
pub struct Kuka;
convention = standard;
| theta      | d     | a     | alpha  |
|------------|-------|-------|--------|
| q1         | 0.4   | 0.025 | -90deg |
| q2 - 90deg | 0     | 0.315 | 0      |
| q3         | 0     | 0.035 | -90deg |
| q4         | 0.365 | 0     | 90deg  |
| q5         | 0     | 0     | -90deg |
| q6         | 0.08  | 0     | 0      |
";
