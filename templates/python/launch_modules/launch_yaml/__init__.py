"""Launch files in YAML, which the evaluator reads itself."""
