"""Launch files in XML, which the evaluator reads itself."""
