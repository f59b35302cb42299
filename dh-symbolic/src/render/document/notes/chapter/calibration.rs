//! Calibration: how the pose changes with every cell of the table, and which deviations measured poses can tell apart.

use super::identifiable::{Cell, Deviation, deviations};
use super::{Block, Math, NotesWriter, Span, Text};
use crate::chain::Convention;

impl NotesWriter<'_> {
    /// The part of the note.
    pub(in super::super) fn calibration(&mut self) {
        if self.chain.dof() == 0 {
            return;
        }
        self.title(1, "Calibration", "标定");
        self.derivatives();
        let list = deviations(self.chain);
        self.told_apart(&list);
    }

    /// The derivative of the pose by a cell.
    fn derivatives(&mut self) {
        let n = Math::number(self.chain.links.len());
        self.tell_both(
            "A small deviation of one cell moves all that stands behind it, along or about one axis. Let $B_k$ be the transform between frames 0 and $k$, and $E_k$ the one between frame $k$ and frame $#0$, so that $T = B_k E_k$ for every $k$. The derivative of $T$ by a cell of row $i$ has one more factor between the two:",
            "某一单元的微小偏差使其后的一切沿某轴移动或绕某轴转动。设 $B_k$ 为坐标系 0 与 $k$ 之间的变换，$E_k$ 为坐标系 $k$ 与 $#0$ 之间的变换，则对任意 $k$ 有 $T = B_k E_k$。$T$ 对第 $i$ 行某一单元的导数在两者之间多一个因子：",
            &[n],
        );
        let (across, along, index) = match self.chain.convention {
            Convention::Standard => ("i", "i-1", "i"),
            Convention::Modified => ("i-1", "i", "i-1"),
        };
        for (cell, index, frame, factor) in [
            ("\\alpha", index, across, "X_r"),
            ("a", index, across, "X_t"),
            ("d", "i", along, "Z_t"),
            ("\\theta", "i", along, "Z_r"),
        ] {
            let text = format!("\\frac{{∂T}}{{∂{cell}_{{{index}}}}} = B_{{{frame}}} {factor} E_{{{frame}}}");
            self.show_numbered(&text, &[]);
        }
        self.tell_both("with the constant factors", "其中常数因子为", &[]);
        self.show(
            &[
                "X_r = \\mat{0 & 0 & 0 & 0; 0 & 0 & -1 & 0; 0 & 1 & 0 & 0; 0 & 0 & 0 & 0}",
                "X_t = \\mat{0 & 0 & 0 & 1; 0 & 0 & 0 & 0; 0 & 0 & 0 & 0; 0 & 0 & 0 & 0}",
                "Z_r = \\mat{0 & -1 & 0 & 0; 1 & 0 & 0 & 0; 0 & 0 & 0 & 0; 0 & 0 & 0 & 0}",
                "Z_t = \\mat{0 & 0 & 0 & 0; 0 & 0 & 0 & 0; 0 & 0 & 0 & 1; 0 & 0 & 0 & 0}",
            ],
            &[],
        );
    }

    /// Which deviations have an effect of their own.
    fn told_apart(&mut self, list: &[Deviation]) {
        let own = list.iter().filter(|d| d.same_as.is_none()).count();
        let pieces = [own, list.len(), own.div_ceil(6)].map(Math::number);
        self.tell_both(
            "Of the $#1$ deviations in this table, measured poses (position and orientation) tell $#0$ apart. A pose gives six equations: at least $#2$ poses are needed, and more against errors of measurement.",
            "由测得的位姿（位置与姿态）可区分本表 $#1$ 个偏差中的 $#0$ 个。每个位姿给出六个方程，故至少需要 $#2$ 个位姿；为抑制测量误差应取更多。",
            &pieces,
        );
        if list.iter().any(|d| d.cell == Cell::Beta) {
            self.tell_both(
                "Where neighbouring axes are parallel, no small change of the four cells lets one lean against the other in the plane of both, and only the sum of their offsets counts. There a turn $\\beta$ about y takes the place of one offset $d$ (Hayati).",
                "相邻两轴平行时，四个单元的任何微小变化都不能使一轴在两轴所在平面内倾斜，且只有两偏置之和起作用。此时以绕 y 轴的转角 $\\beta$ 代替其中一个偏置 $d$（Hayati）。",
                &[],
            );
        }
        let columns = [Cell::Alpha, Cell::A, Cell::D, Cell::Theta, Cell::Beta];
        let used: Vec<Cell> = columns.into_iter().filter(|c| list.iter().any(|d| d.cell == *c)).collect();
        let mut header = vec![Text::from(self.both("row", "行"))];
        header.extend(used.iter().map(|c| Text(vec![Span::Math(self.formula(letter(*c), &[]))])));
        let rows = (0..self.chain.links.len()).map(|row| {
            let mut line = vec![Text::from((row + 1).to_string())];
            line.extend(used.iter().map(|cell| {
                let Some(d) = list.iter().find(|d| d.row == row && d.cell == *cell) else { return Text::default() };
                self.verdict(d)
            }));
            line
        });
        let rows = rows.collect();
        self.blocks.push(Block::Table(header, rows));
    }

    /// A cell of the table of verdicts.
    fn verdict(&self, deviation: &Deviation) -> Text {
        let Some(others) = &deviation.same_as else { return Text::from(self.both("of its own", "独立")) };
        let names: Vec<Math> = others
            .iter()
            .map(|(row, cell)| {
                let shifted = matches!(cell, Cell::Alpha | Cell::A) && self.chain.convention == Convention::Modified;
                let index = if shifted { *row } else { row + 1 };
                self.formula(&format!("{}_{{{index}}}", letter(*cell)), &[])
            })
            .collect();
        let mut text = Text::from(self.both("same as ", "同 "));
        text.0.push(Span::Math(Math::list(&names)));
        text
    }
}

fn letter(cell: Cell) -> &'static str {
    match cell {
        Cell::Alpha => "\\alpha",
        Cell::A => "a",
        Cell::D => "d",
        Cell::Theta => "\\theta",
        Cell::Beta => "\\beta",
    }
}
