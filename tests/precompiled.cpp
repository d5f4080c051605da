// Source of the object libraries that compile headers once for other targets: a library needs a source.
