# R (stats)
#
# `KalmanRun` is part of R and reads one number a step; a matrix of two columns it reads as one long series, without an
# error. By default (`nit = 0L`) the mean `a` holds one step before the first reading and the covariance `Pn` at it;
# with `nit = -1L` both hold one step before, `P` is the covariance and `Pn` is not used. `P` comes back for the last
# reading only, hence the loop. `Lik` is not the log-likelihood of the given variances. It is ½ (log s² + the mean of
# log S), where S is the variance of the innovation y, and s² is the mean of y²/S over the readings that are there. It
# is smallest where the readings are most probable if one factor of all variances may be chosen as well. The last three
# lines make the log-likelihood of it. `StructTS` estimates the variances and takes no start: its own is the first
# reading, with a variance of 10⁴ times that of the series.
#
# one: reading

# plain

done <- KalmanRun(z, list(T = F, Z = H, h = R, V = Q, a = x, P = P, Pn = P))
means <- done$states
log_likelihood <- done$values[["Lik"]]
covs <- array(0, c(length(z), length(x), length(x)))
for (t in seq_along(z)) {
  part <- KalmanRun(z[1:t], list(T = F, Z = H, h = R, V = Q, a = x, P = P, Pn = P), update = TRUE)
  covs[t, , ] <- attr(part, "mod")$P
}

# same

model <- list(T = F, Z = H, h = R, V = Q, a = x, P = P, Pn = P)
done <- KalmanRun(z, model, nit = -1L)
means <- done$states
covs <- array(0, c(length(z), length(x), length(x)))
for (t in seq_along(z)) {
  covs[t, , ] <- attr(KalmanRun(z[1:t], model, nit = -1L, update = TRUE), "mod")$P
}
N <- sum(!is.na(z))
s2 <- done$values[["s2"]]
log_likelihood <- -N / 2 * (log(2 * pi) + 2 * done$values[["Lik"]] - log(s2) + s2)
