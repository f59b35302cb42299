//! Example robots.
