//! Chapter 1: ray tracer design and programming.
