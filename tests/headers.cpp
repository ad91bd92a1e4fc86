// Nothing: the target is there for the headers that it compiles.
