//! Chapter 2: some essential mathematics.
