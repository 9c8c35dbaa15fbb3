// kalman-filter (npm)
//
// A gap is `predict` alone. NaN and a missing list are errors, but null inside a list, `[null]`, is read as 0. What it
// refuses with R = −1 is the negative variance of an estimate: R = −100 gives no error, because then S is negative
// too. There is no likelihood.
//
// needs: kalman-filter@2.3.0

// plain

const {KalmanFilter} = require("kalman-filter");
const observation = {dimension: R.length, stateProjection: H, covariance: R};
const init = {mean: x, covariance: P, index: -1};
const kf = new KalmanFilter({observation, dynamic: {dimension: x.length, init, transition: F, covariance: Q}});
const means = [], covs = [];
let belief = kf.getInitState();
for (const reading of z) {
  belief = kf.filter({previousCorrected: belief, observation: reading});
  means.push(belief.mean);
  covs.push(belief.covariance);
}

// same

const {KalmanFilter} = require("kalman-filter");
const observation = {dimension: R.length, stateProjection: H, covariance: R};
const init = {mean: x, covariance: P, index: -1};
const kf = new KalmanFilter({observation, dynamic: {dimension: x.length, init, transition: F, covariance: Q}});
const means = [], covs = [];
let belief = kf.getInitState();
for (const reading of z) {
  belief = kf.predict({previousCorrected: belief});
  if (!reading.some(Number.isNaN)) belief = kf.correct({predicted: belief, observation: reading});
  means.push(belief.mean);
  covs.push(belief.covariance);
}
