"""Names for hints of types: what `remappings` of a node can be."""
RemapRule = RemapRules = SomeRemapRule = SomeRemapRules = object
