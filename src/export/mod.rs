//! Files out: tables.
