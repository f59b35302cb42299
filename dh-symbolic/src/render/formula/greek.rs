//! Greek letters and their names.

/// Names, as commands of LaTeX spell them and as names of a table do.
pub(crate) const GREEK: [(&str, char); 22] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("iota", 'ι'),
];

/// The name of a Greek letter.
#[cfg(feature = "documents")]
pub(crate) fn name(c: char) -> Option<&'static str> {
    let c = match c {
        'ϑ' => 'θ',
        'ϕ' => 'φ',
        'ϵ' => 'ε',
        c => c,
    };
    GREEK.iter().find(|g| g.1 == c).map(|g| g.0)
}

/// The letter of a name.
pub(crate) fn letter(name: &str) -> Option<char> {
    GREEK.iter().find(|g| g.0 == name).map(|g| g.1)
}
