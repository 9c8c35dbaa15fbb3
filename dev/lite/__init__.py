"""The course without an installation: a JupyterLite site, and the lessons under WebAssembly."""
