"""Parts of the implementation that user code imports nevertheless."""
