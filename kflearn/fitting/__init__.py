"""What the data say about a model: likelihood, maximum likelihood with standard errors, EM."""
