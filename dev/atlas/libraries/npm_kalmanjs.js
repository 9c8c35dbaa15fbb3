// kalmanjs (npm)
//
// State and reading are one number each, so only the first problem was asked, with its third reading missing for the
// gap. Its R is our Q, and its Q our R. The constructor takes no start: the first reading becomes the estimate, with
// the variance R/H². The lines set the fields `x` and `cov`, which its README does not mention. NaN makes that step's
// estimate NaN, and the next reading becomes a new start. There is no likelihood.
//
// needs: kalmanjs@1.1.0
// one: state

// plain

const KalmanFilter = require("kalmanjs");
const kf = new KalmanFilter({R: Q[0][0], Q: R[0][0], A: F[0][0], C: H[0][0]});
const means = [], covs = [];
for (const [reading] of z) {
  means.push(kf.filter(reading));
  covs.push(kf.cov);
}

// same

const KalmanFilter = require("kalmanjs");
const kf = new KalmanFilter({R: Q[0][0], Q: R[0][0], A: F[0][0], C: H[0][0]});
kf.x = x[0][0];
kf.cov = P[0][0];
const means = [], covs = [];
for (const [reading] of z) {
  [kf.x, kf.cov] = Number.isNaN(reading) ? [kf.predict(), kf.uncertainty()] : [kf.filter(reading), kf.cov];
  means.push(kf.x);
  covs.push(kf.cov);
}
