//! Chapter 3: bare-bones ray tracing.
