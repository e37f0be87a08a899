"""From exact expressions to forms that double precision evaluates without loss."""
