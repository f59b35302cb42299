//! Which chain of a tree of links is the arm: named by the caller, or the only one that comes into question.

use super::Options;
use super::problem::Problem;
use super::space::norm;
use super::urdf::{Joint, Kind, Model};

/// The chain.
#[derive(Clone, Debug)]
pub(super) struct Route {
    /// Index of the first link.
    pub(super) base: usize,
    /// Index of the last link.
    pub(super) tip: usize,
    /// Indices of the joints from base to tip.
    pub(super) joints: Vec<usize>,
    /// What was decided.
    pub(super) notes: Vec<String>,
}

/// Links that hold a tool, by the usual names; the first that is there is taken.
const TOOLS: [&str; 8] = ["tool0", "tcp", "tool", "ee", "end_effector", "flange", "hand", "gripper"];

/// Finds the chain.
pub(super) fn choose(model: &Model, options: &Options) -> Result<Route, Problem> {
    let roots: Vec<usize> = (0..model.links.len()).filter(|&l| model.joint_above(l).is_none()).collect();
    let mut notes = Vec::new();
    // Every link but one has a joint above it, or the links run in a circle.
    let (base, tip) = match (&options.base, &options.tip) {
        (base, Some(tip)) => {
            let tip = find(model, tip)?;
            let base = match base {
                Some(base) => find(model, base)?,
                None => *path(model, None, tip)?.1.first().unwrap_or(&tip),
            };
            (base, tip)
        }
        (base, None) => {
            let base = match base {
                Some(base) => find(model, base)?,
                None => only_root(model, &roots)?,
            };
            (base, guess(model, base, &mut notes)?)
        }
    };
    let joints = path(model, Some(base), tip)?.0;
    let moving = joints.iter().filter(|&&j| model.joints[j].kind != Kind::Fixed).count();
    if moving == 0 {
        let text = format!("nothing moves between `{}` and `{}`", model.links[base], model.links[tip]);
        return Err(Problem::new(text).help(list(model, base)));
    }
    if let Some(j) = joints.iter().map(|&j| &model.joints[j]).find(|j| j.kind == Kind::Other) {
        let text = format!("joint `{}` has several degrees of freedom, and stands between base and tip", j.name);
        return Err(Problem::at(j.at, text).help("choose a chain behind it: `--base LINK`"));
    }
    let chain = format!("chain {}..{}, {moving} moving joints", model.links[base], model.links[tip]);
    notes.insert(0, chain);
    notes.extend(left_out(model, base, &joints));
    Ok(Route { base, tip, joints, notes })
}

fn find(model: &Model, name: &str) -> Result<usize, Problem> {
    model.links.iter().position(|l| l == name).ok_or_else(|| {
        let shown: Vec<&str> = model.links.iter().take(30).map(String::as_str).collect();
        let more = if model.links.len() > shown.len() { ", ..." } else { "" };
        Problem::new(format!("there is no link `{name}`")).help(format!("the links: {}{more}", shown.join(", ")))
    })
}

fn only_root(model: &Model, roots: &[usize]) -> Result<usize, Problem> {
    // A link without any joint is no start.
    let roots: Vec<usize> = roots.iter().copied().filter(|&l| model.joints.iter().any(|j| j.parent == l)).collect();
    match roots.as_slice() {
        [root] => Ok(*root),
        [] => Err(Problem::at(model.joints[0].at, "the links run in a circle: no link is the first")),
        several => {
            let names: Vec<&str> = several.iter().map(|&l| model.links[l].as_str()).collect();
            Err(Problem::new(format!("several links are the first of a tree: {}", names.join(", ")))
                .help("say where the arm stands: `--base LINK`"))
        }
    }
}

/// Joints and links from `base` (or the root) down to `tip`.
fn path(model: &Model, base: Option<usize>, tip: usize) -> Result<(Vec<usize>, Vec<usize>), Problem> {
    let (mut joints, mut links) = (Vec::new(), vec![tip]);
    let mut at = tip;
    while Some(at) != base {
        let Some(j) = model.joint_above(at) else {
            let Some(base) = base else { break };
            let text = format!("link `{}` does not stand above link `{}`", model.links[base], model.links[tip]);
            let way: Vec<&str> = links.iter().rev().map(|&l| model.links[l].as_str()).collect();
            return Err(Problem::new(text).help(format!("above it: {}", way.join(", "))));
        };
        joints.push(j);
        at = model.joints[j].parent;
        if links.contains(&at) {
            let text = format!("the links run in a circle: `{}` stands above itself", model.links[at]);
            return Err(Problem::at(model.joints[j].at, text));
        }
        links.push(at);
    }
    joints.reverse();
    links.reverse();
    Ok((joints, links))
}

/// The moving joints on the way from `base` to a leaf.
struct Leaf {
    link: usize,
    links: Vec<usize>,
    moving: Vec<usize>,
    /// Length of the way behind the last moving joint.
    behind: f64,
}

/// All leaves below `base` with their moving joints.
fn leaves(model: &Model, base: usize) -> Result<Vec<Leaf>, Problem> {
    let mut all = Vec::new();
    for link in (0..model.links.len()).filter(|&l| model.joints.iter().all(|j| j.parent != l)) {
        let (_, above) = path(model, None, link)?;
        if !above.contains(&base) {
            continue;
        }
        let (joints, links) = path(model, Some(base), link)?;
        let fixed = |j: &&usize| model.joints[**j].kind == Kind::Fixed;
        let behind = joints.iter().rev().take_while(fixed).map(|&j| norm(model.joints[j].xyz)).sum();
        let moving = joints.into_iter().filter(|&j| model.joints[j].kind != Kind::Fixed).collect();
        all.push(Leaf { link, links, moving, behind });
    }
    Ok(all)
}

/// How much the name of a link says that a tool is mounted there; 0 is most.
fn rank(model: &Model, link: usize) -> usize {
    let name = model.links[link].to_lowercase();
    let name = name.trim_end_matches("_link").trim_end_matches("_frame");
    TOOLS.iter().position(|t| name == *t || name.ends_with(&format!("_{t}"))).unwrap_or(TOOLS.len())
}

/// The only chain that comes into question: all leaves that move share its joints (what moves behind it are fingers).
fn guess(model: &Model, base: usize, notes: &mut Vec<String>) -> Result<usize, Problem> {
    let leaves = leaves(model, base)?;
    if leaves.is_empty() {
        // Everything below runs in a circle.
        return path(model, Some(base), model.joints[0].child).map(|_| model.joints[0].child);
    }
    // An arm is a chain that no other one goes on from; side branches (pistons, covers) have few joints, and leave it early.
    let goes_on = |l: &Leaf| leaves.iter().any(|m| m.moving.len() > l.moving.len() && m.moving.starts_with(&l.moving));
    let most = leaves.iter().map(|l| l.moving.len()).max().unwrap_or(0);
    let long: Vec<&Leaf> = leaves.iter().filter(|l| !goes_on(l) && l.moving.len() * 3 > most * 2).collect();
    let Some(first) = long.first().copied() else { return Ok(leaves[0].link) };
    let shared = (0..most).take_while(|&i| long.iter().all(|l| l.moving.get(i) == first.moving.get(i))).count();
    // What stands behind the arm: fingers, each a joint or two.
    if shared == 0 || shared + 2 < most {
        return Err(Problem::new("several chains come into question").help(list(model, base)));
    }
    let ends = |n: usize| {
        let mut ends: Vec<&Leaf> = leaves.iter().filter(|l| l.moving == first.moving[..n]).collect();
        let far = |l: &Leaf| -l.behind;
        ends.sort_by(|a, b| rank(model, a.link).cmp(&rank(model, b.link)).then(far(a).total_cmp(&far(b))));
        ends
    };
    let mut found = ends(shared);
    // A jaw that is the last joint: the arm ends before it, where a tool is named.
    for n in (shared.saturating_sub(2).max(1)..shared).rev() {
        let before = ends(n);
        if found.first().is_none_or(|l| rank(model, l.link) == TOOLS.len())
            && before.first().is_some_and(|l| rank(model, l.link) < TOOLS.len())
        {
            found = before;
        }
    }
    let tip = match found.first() {
        Some(leaf) => leaf.link,
        // The last link before the fingers part.
        None => (0..)
            .map_while(|i| {
                let link = *first.links.get(i)?;
                long.iter().all(|l| l.links.get(i) == Some(&link)).then_some(link)
            })
            .last()
            .unwrap_or(base),
    };
    let ends = found;
    let others: Vec<&str> = ends.iter().filter(|l| l.link != tip).map(|l| model.links[l.link].as_str()).collect();
    if !others.is_empty() {
        notes.push(format!("other ends of the same arm: {} (`--tip LINK` takes one)", others.join(", ")));
    }
    Ok(tip)
}

/// The chains that there are, for a message.
fn list(model: &Model, base: usize) -> String {
    let Ok(leaves) = leaves(model, base) else { return "say which: `--base LINK --tip LINK`".into() };
    let mut lines = vec!["say which one: `--base LINK --tip LINK`".to_string()];
    for leaf in leaves.iter().filter(|l| !l.moving.is_empty()).take(20) {
        let n = leaf.moving.len();
        lines.push(format!("    {}..{}  ({n} moving joints)", model.links[base], model.links[leaf.link]));
    }
    lines.join("\n")
}

/// Moving joints that are no part of the chain.
fn left_out(model: &Model, base: usize, joints: &[usize]) -> Vec<String> {
    let below = |j: &Joint| path(model, None, j.child).is_ok_and(|(_, links)| links.contains(&base));
    let out: Vec<String> = model
        .joints
        .iter()
        .enumerate()
        .filter(|(i, j)| j.kind != Kind::Fixed && !joints.contains(i) && below(j))
        .map(|(_, j)| match &j.mimic {
            Some(m) => format!("{} (follows {})", j.name, m.joint),
            None => j.name.clone(),
        })
        .collect();
    if out.is_empty() {
        Vec::new()
    } else {
        vec![format!("left out, since they are not on the chain: {}", out.join(", "))]
    }
}
