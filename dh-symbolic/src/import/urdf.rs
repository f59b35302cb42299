//! URDF: links and joints of a robot as written, with their lines.

use super::problem::Problem;
use roxmltree::{Document, Node};

/// Nothing is read beyond these limits.
const MOST_JOINTS: usize = 1000;

/// A robot as written.
#[derive(Clone, Debug)]
pub(super) struct Model {
    /// Name of the robot.
    pub(super) name: String,
    /// The links in the order of the file.
    pub(super) links: Vec<String>,
    /// The joints in the order of the file.
    pub(super) joints: Vec<Joint>,
    /// Per link: the joint that holds it.
    above: Vec<Option<usize>>,
}

/// How a joint moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// It doesn't.
    Fixed,
    /// Turns within limits.
    Revolute,
    /// Turns without limits.
    Continuous,
    /// Slides.
    Prismatic,
    /// `floating`, `planar`: several degrees of freedom.
    Other,
}

/// `<joint>`.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) kind: Kind,
    /// Indices of the links.
    pub(super) parent: usize,
    pub(super) child: usize,
    /// Position and roll, pitch, yaw of the child at zero.
    pub(super) xyz: [f64; 3],
    pub(super) rpy: [f64; 3],
    /// Direction of motion in the child's frame, as written.
    pub(super) axis: [f64; 3],
    /// `lower` and `upper` as written.
    pub(super) limits: Option<(String, String)>,
    /// Follows another joint.
    pub(super) mimic: Option<Mimic>,
    /// Line and column of the element.
    pub(super) at: (usize, usize),
}

/// `<mimic>`: value = multiplier * other + offset.
#[derive(Clone, Debug)]
pub(super) struct Mimic {
    pub(super) joint: String,
    pub(super) multiplier: f64,
    pub(super) offset: f64,
    pub(super) at: (usize, usize),
}

impl Model {
    /// The joint that holds a link.
    pub(super) fn joint_above(&self, link: usize) -> Option<usize> {
        self.above.get(link).copied().flatten()
    }
}

struct Reader<'a> {
    document: &'a Document<'a>,
}

/// Reads the links and joints.
pub(super) fn read(text: &str) -> Result<Model, Problem> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        return Err(Problem::new("the file is empty"));
    }
    // Entities that grow when they are put in place are no part of URDF files.
    let document = Document::parse(text).map_err(|e| {
        let at = e.pos();
        Problem::at((at.row as usize, at.col as usize), format!("this is no XML: {}", plain(&e.to_string())))
    })?;
    let reader = Reader { document: &document };
    let root = document.root_element();
    // An unexpanded xacro has elements and properties of its own.
    if let Some(node) =
        document.descendants().find(|n| n.is_element() && n.tag_name().namespace().is_some_and(is_xacro))
    {
        let text = format!("this is a xacro file (`xacro:{}`): it must be expanded first", node.tag_name().name());
        return Err(
            Problem::at(reader.at(&node), text).help("run `xacro arm.urdf.xacro > arm.urdf`, then import arm.urdf")
        );
    }
    if root.tag_name().name() != "robot" {
        let text = format!("this is no URDF file: its root is `{}`, not `robot`", root.tag_name().name());
        return Err(Problem::at(reader.at(&root), text));
    }
    let name = root.attribute("name").unwrap_or("").to_string();
    let mut model = Model { name, links: Vec::new(), joints: Vec::new(), above: Vec::new() };
    for node in reader.children(&root, "link") {
        let name = reader.name(&node)?;
        if model.links.contains(&name) {
            return Err(Problem::at(reader.at(&node), format!("there are two links `{name}`")));
        }
        model.links.push(name);
    }
    model.above = vec![None; model.links.len()];
    // Only direct children: `transmission` and `ros2_control` elements hold `joint` elements of another kind.
    for node in reader.children(&root, "joint") {
        let joint = reader.joint(&node, &model.links)?;
        if model.joints.iter().any(|j| j.name == joint.name) {
            return Err(Problem::at(joint.at, format!("there are two joints `{}`", joint.name)));
        }
        if let Some(other) = model.joint_above(joint.child).map(|j| &model.joints[j]) {
            let link = &model.links[joint.child];
            let text = format!(
                "link `{link}` is the child of `{}` already (line {}): this is no tree",
                other.name, other.at.0
            );
            return Err(Problem::at(joint.at, text));
        }
        if model.joints.len() == MOST_JOINTS {
            return Err(Problem::at(joint.at, format!("more than {MOST_JOINTS} joints")));
        }
        model.above[joint.child] = Some(model.joints.len());
        model.joints.push(joint);
    }
    if model.joints.is_empty() {
        return Err(Problem::at(reader.at(&root), "there is no joint in this file"));
    }
    Ok(model)
}

fn is_xacro(namespace: &str) -> bool {
    namespace.contains("xacro")
}

/// The message of the XML reader without its own position.
fn plain(message: &str) -> String {
    message.rsplit_once(" at ").map_or(message, |(m, _)| m).to_string()
}

impl Reader<'_> {
    fn at(&self, node: &Node<'_, '_>) -> (usize, usize) {
        let at = self.document.text_pos_at(node.range().start);
        (at.row as usize, at.col as usize)
    }

    fn at_attribute(&self, node: &Node<'_, '_>, name: &str) -> (usize, usize) {
        let Some(attribute) = node.attribute_node(name) else { return self.at(node) };
        let at = self.document.text_pos_at(attribute.range_value().start);
        (at.row as usize, at.col as usize)
    }

    fn children<'a>(&self, node: &Node<'a, 'a>, name: &'static str) -> impl Iterator<Item = Node<'a, 'a>> {
        node.children().filter(move |n| n.is_element() && n.tag_name().name() == name)
    }

    fn name(&self, node: &Node<'_, '_>) -> Result<String, Problem> {
        match node.attribute("name") {
            Some(name) if !name.trim().is_empty() => Ok(name.trim().to_string()),
            _ => Err(Problem::at(self.at(node), format!("this `{}` has no name", node.tag_name().name()))),
        }
    }

    fn number(&self, node: &Node<'_, '_>, name: &str, default: f64) -> Result<f64, Problem> {
        let Some(text) = node.attribute(name) else { return Ok(default) };
        parse(text).map_err(|e| Problem::at(self.at_attribute(node, name), e))
    }

    /// Three numbers.
    fn triple(&self, node: &Node<'_, '_>, name: &str, default: [f64; 3]) -> Result<[f64; 3], Problem> {
        let Some(text) = node.attribute(name) else { return Ok(default) };
        let problem = |e: String| Problem::at(self.at_attribute(node, name), e);
        let mut list = [0.0; 3];
        let mut words = text.split_whitespace();
        for x in &mut list {
            let word =
                words.next().ok_or_else(|| problem(format!("`{name}` takes three numbers, and this is `{text}`")))?;
            *x = parse(word).map_err(problem)?;
        }
        if words.next().is_some() {
            return Err(problem(format!("`{name}` takes three numbers, and this is `{text}`")));
        }
        Ok(list)
    }

    fn link(&self, node: &Node<'_, '_>, name: &'static str, links: &[String]) -> Result<usize, Problem> {
        let Some(element) = node.children().find(|n| n.is_element() && n.tag_name().name() == name) else {
            return Err(Problem::at(self.at(node), format!("this joint has no `{name}`")));
        };
        let Some(link) = element.attribute("link").map(str::trim) else {
            return Err(Problem::at(self.at(&element), format!("this `{name}` names no link")));
        };
        links.iter().position(|l| l == link).ok_or_else(|| {
            Problem::at(self.at_attribute(&element, "link"), format!("there is no link `{link}` in this file"))
        })
    }

    fn joint(&self, node: &Node<'_, '_>, links: &[String]) -> Result<Joint, Problem> {
        let name = self.name(node)?;
        let first = |name: &str| node.children().find(|n| n.is_element() && n.tag_name().name() == name);
        let kind = match node.attribute("type").map(str::trim) {
            Some("fixed") => Kind::Fixed,
            Some("revolute") => Kind::Revolute,
            Some("continuous") => Kind::Continuous,
            Some("prismatic") => Kind::Prismatic,
            Some("floating" | "planar") => Kind::Other,
            Some(other) => {
                let text = format!("joint `{name}` has the unknown type `{other}`");
                return Err(Problem::at(self.at_attribute(node, "type"), text)
                    .help("revolute, continuous, prismatic, fixed, floating or planar"));
            }
            None => return Err(Problem::at(self.at(node), format!("joint `{name}` has no type"))),
        };
        let (parent, child) = (self.link(node, "parent", links)?, self.link(node, "child", links)?);
        if parent == child {
            return Err(Problem::at(self.at(node), format!("joint `{name}` ties link `{}` to itself", links[parent])));
        }
        let (mut xyz, mut rpy) = ([0.0; 3], [0.0; 3]);
        if let Some(origin) = first("origin") {
            xyz = self.triple(&origin, "xyz", xyz)?;
            rpy = self.triple(&origin, "rpy", rpy)?;
        }
        let mut axis = [1.0, 0.0, 0.0];
        if let Some(element) = first("axis") {
            axis = self.triple(&element, "xyz", axis)?;
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            if kind != Kind::Fixed && !(1e-6..1e6).contains(&length) {
                let text = format!("the axis of joint `{name}` has no direction");
                return Err(Problem::at(self.at_attribute(&element, "xyz"), text));
            }
        }
        let mut limits = None;
        if let (Some(limit), Kind::Revolute | Kind::Prismatic) = (first("limit"), kind) {
            let bound = |name: &str| -> Result<String, Problem> {
                self.number(&limit, name, 0.0)?;
                Ok(limit.attribute(name).unwrap_or("0").trim().to_string())
            };
            if limit.attribute("lower").is_some() || limit.attribute("upper").is_some() {
                limits = Some((bound("lower")?, bound("upper")?));
            }
        }
        let mimic = match first("mimic") {
            Some(m) => Some(Mimic {
                joint: match m.attribute("joint") {
                    Some(j) => j.trim().to_string(),
                    None => return Err(Problem::at(self.at(&m), "this `mimic` names no joint")),
                },
                multiplier: self.number(&m, "multiplier", 1.0)?,
                offset: self.number(&m, "offset", 0.0)?,
                at: self.at(&m),
            }),
            None => None,
        };
        Ok(Joint { name, kind, parent, child, xyz, rpy, axis, limits, mimic, at: self.at(node) })
    }
}

/// A finite number that an arm can have.
fn parse(word: &str) -> Result<f64, String> {
    let word = word.trim();
    match word.parse::<f64>() {
        Ok(x) if x.is_finite() && x.abs() <= 1e6 => Ok(x),
        Ok(x) if x.is_finite() => Err(format!("`{word}` is beyond all reason")),
        Ok(_) => Err(format!("`{word}` is not finite")),
        Err(_) if word.contains("${") => {
            Err(format!("`{word}` is a property of xacro: the file must be expanded first"))
        }
        Err(_) => Err(format!("`{word}` is no number")),
    }
}
