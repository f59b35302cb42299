//! Splits a table into rows and cells at its bars; line breaks only help to word the errors.
//!
//! A cell is never empty, so two bars side by side end one row and start the next.

use super::cursor::{Cursor, unwrapped};
use super::text;
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::TokenTree;

/// A header, for messages.
const HEADER: &str = "a table starts with `| joint | alpha | a | d | theta | range |`";

const NO_BAR: &str = "the closing bar `|` is missing after this";

/// One cell.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    /// Empty where the cell is empty, or could not be told from its neighbours.
    pub(super) tokens: Vec<TokenTree>,
    /// Its tokens, or the bars around nothing.
    pub(super) place: Place,
}

/// One row.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) cells: Vec<Cell>,
    /// From its first bar to its last.
    pub(super) place: Place,
    /// Whether it has as many cells as the header.
    pub(super) fits: bool,
}

/// Header and rows.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    pub(super) header: Row,
    pub(super) rows: Vec<Row>,
    pub(super) place: Place,
}

/// What stands between two bars.
struct Segment<'a> {
    tokens: &'a [TokenTree],
    /// The bar before.
    open: Place,
    /// The bar behind (the last token, where it is missing).
    close: Place,
    /// Whether there is a bar behind.
    closed: bool,
}

impl Segment<'_> {
    fn is_gap(&self) -> bool {
        self.tokens.is_empty()
    }

    fn on_one_line(&self) -> bool {
        let line = self.open.line();
        line != 0 && line == self.close.line()
    }

    fn cell(&self) -> Cell {
        let place = Place::of_all(self.tokens).unwrap_or_else(|| self.open.to(self.close));
        Cell { tokens: unwrapped(self.tokens.iter().cloned()), place }
    }
}

/// `---`, `:--:`.
fn is_rule(tokens: &[TokenTree]) -> bool {
    let dash = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == '-');
    let colon = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == ':');
    tokens.iter().any(dash) && tokens.iter().all(|t| dash(t) || colon(t))
}

/// Reads from the first bar to the end of the table.
pub(super) fn read(c: &mut Cursor<'_>, errors: &mut Errors) -> Grid {
    let segments = segments(c);
    let mut rest = segments.as_slice();
    let header = header(&mut rest, errors);
    let columns = header.cells.len();
    if columns == 0 {
        errors.push(Error::new(header.place, "the header is missing").help(HEADER));
        return Grid { place: header.place, header, rows: Vec::new() };
    }
    // A rule line can only stand here.
    if rest.first().is_some_and(|s| is_rule(s.tokens)) {
        let count = rest.iter().take_while(|s| is_rule(s.tokens)).count();
        let (rule, after) = rest.split_at(count);
        if let (Some(first), Some(last), true) = (rule.first(), rule.last(), count != columns) {
            let text = format!("this rule line has {}, the header has {columns}", counted(count));
            errors.push(Error::new(first.open.to(last.close), text));
        }
        rest = after;
        skip_gap(&mut rest);
    }
    let rows = rows(rest, &header, errors);
    let place = rows.last().map_or(header.place, |r| header.place.to(r.place));
    Grid { header, rows, place }
}

/// Cuts at the bars. The table ends where a line of another kind starts.
fn segments<'a>(c: &mut Cursor<'a>) -> Vec<Segment<'a>> {
    let mut list = Vec::new();
    let Some(mut open) = c.eat_punct('|') else { return list };
    loop {
        let tokens = c.take_while(|c| !c.is_punct(0, '|') && !c.is_punct(0, ';') && !c.starts_line());
        match c.eat_punct('|') {
            Some(close) => {
                list.push(Segment { tokens, open, close, closed: true });
                open = close;
            }
            None => {
                if let Some(place) = Place::of_all(tokens) {
                    list.push(Segment { tokens, open, close: place, closed: false });
                    c.eat_punct(';');
                }
                return list;
            }
        }
    }
}

fn skip_gap(rest: &mut &[Segment<'_>]) {
    if let Some((gap, after)) = rest.split_first()
        && gap.is_gap()
    {
        *rest = after;
    }
}

fn header(rest: &mut &[Segment<'_>], errors: &mut Errors) -> Row {
    let start = rest.first().map_or_else(Place::call_site, |s| s.open);
    let mut row = Row { cells: Vec::new(), place: start, fits: true };
    while let Some((segment, after)) = rest.split_first() {
        if segment.is_gap() {
            // An empty name: more names follow on the line, and the table has more lines than this one.
            let line = segment.open.line();
            let goes_on = segment.on_one_line()
                && after.first().is_some_and(|s| !s.is_gap() && s.close.line() == line)
                && after.last().is_some_and(|s| s.close.line() > line);
            *rest = after;
            if !goes_on {
                return row;
            }
            errors.push(Error::new(segment.open.to(segment.close), "this column has no name"));
        } else if is_rule(segment.tokens) && after.first().is_some_and(|s| is_rule(s.tokens)) {
            errors.push(Error::new(row.place, "the closing bar `|` of the header is missing"));
            return row;
        } else {
            if !segment.closed {
                errors.push(Error::new(segment.close, NO_BAR));
            }
            *rest = after;
        }
        row.cells.push(segment.cell());
        row.place = row.place.to(segment.close);
    }
    row
}

/// Puts the cells into rows as wide as the header.
fn rows(segments: &[Segment<'_>], header: &Row, errors: &mut Errors) -> Vec<Row> {
    let columns = header.cells.len();
    let mut list = Vec::new();
    let mut row: Option<Row> = None;
    // The next gap is the one between two rows, since the row has been ended already.
    let mut between = false;
    for (i, segment) in segments.iter().enumerate() {
        let count = row.as_ref().map_or(0, |r| r.cells.len());
        let (before, after) = (i.checked_sub(1).and_then(|i| segments.get(i)), segments.get(i + 1));
        let empty = segment.open.to(segment.close);
        if segment.is_gap() && count >= columns {
            let Some(mut done) = row.take() else { continue };
            if after.is_none_or(|s| segment.on_one_line() && s.is_gap() && !s.on_one_line()) {
                errors.push(Error::new(empty, "an empty cell too many at the end of this row"));
                done.fits = false;
                between = true;
            }
            finish(done, header, errors, &mut list);
            continue;
        }
        if segment.is_gap() && !segment.on_one_line() {
            match row.take() {
                Some(done) => finish(done, header, errors, &mut list),
                None if between => {}
                None => errors.push(Error::new(empty, "a row without cells")),
            }
            between = false;
            continue;
        }
        let mut fits = true;
        if segment.is_gap() {
            errors.push(Error::new(empty, "an empty cell").help("write `0`, or `-` where a range is not known"));
            fits = false;
        } else if count == columns
            && segment.closed
            && before.is_some_and(|b| ends_above(b, segment))
            && let Some(done) = row.take()
        {
            if let Some(last) = done.cells.last() {
                errors.push(Error::new(last.place, "the closing bar `|` of this row is missing"));
            }
            finish(done, header, errors, &mut list);
        }
        between = false;
        if !segment.closed {
            if row.as_ref().is_some_and(|r| r.cells.len() == columns) {
                errors.push(Error::new(segment.cell().place, "this belongs to no line of the table"));
                continue;
            }
            errors.push(Error::new(segment.cell().place, NO_BAR));
        }
        let now = row.get_or_insert_with(|| Row { cells: Vec::new(), place: segment.open, fits: true });
        now.cells.push(segment.cell());
        now.place = now.place.to(segment.close);
        now.fits &= fits;
    }
    if let Some(done) = row {
        finish(done, header, errors, &mut list);
    }
    list
}

/// `1 cell`, `5 cells`.
fn counted(n: usize) -> String {
    format!("{n} cell{}", if n == 1 { "" } else { "s" })
}

/// Whether the text of a cell ends on a line above the one where the next starts.
fn ends_above(before: &Segment<'_>, segment: &Segment<'_>) -> bool {
    let end = Place::of_all(before.tokens).map_or(0, Place::last_line);
    end != 0 && end < segment.cell().place.line()
}

/// Checks the number of cells, unless something else is wrong with them. A row with an empty cell is still read if it is wide enough.
fn finish(mut row: Row, header: &Row, errors: &mut Errors, list: &mut Vec<Row>) {
    let (have, want) = (row.cells.len(), header.cells.len());
    if have != want && row.fits {
        let names: Vec<String> = header.cells.iter().map(|c| text::of(&c.tokens)).collect();
        let text = format!("this row has {}, the header has {want}: {}", counted(have), names.join(", "));
        let error = Error::new(row.place, text);
        let broken = row.cells.windows(2).find(|pair| match pair {
            [a, b] => a.place.last_line() != 0 && a.place.last_line() < b.place.line(),
            _ => false,
        });
        errors.push(match broken.and_then(|pair| pair.first()) {
            Some(cell) if have > want => error.related(cell.place, "is the closing bar missing after this cell?"),
            _ => error,
        });
    }
    row.fits = have == want;
    list.push(row);
}
