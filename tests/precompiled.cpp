// Of the targets that compile headers once for others: a library has a source.
