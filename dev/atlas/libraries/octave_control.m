# Octave (control)
#
# `dlqe` gives the gain M and the covariances of the steady state, `ahead` before a reading and Z after it, those of
# `steady_state(model)`. The package has no filter over readings: the loop is ours, with the same gain from the first
# reading on, so only the last of many estimates are those of `kflearn`; the figure is that of the last of 48. With R =
# −1 it gives the variance Z = −2.

# plain

pkg load control
[M, ahead, Z] = dlqe(F, [], H, Q, R);
means = zeros(rows(z), rows(x));
covs = repmat(Z, 1, 1, rows(z));
for t = 1:rows(z)
  x = F * x;
  x = x + M * (z(t, :)' - H * x);
  means(t, :) = x';
end

# same

pkg load control
[M, ahead, Z] = dlqe(F, [], H, Q, R);
means = zeros(rows(z), rows(x));
covs = repmat(Z, 1, 1, rows(z));
for t = 1:rows(z)
  x = F * x;
  x = x + M * (z(t, :)' - H * x);
  means(t, :) = x';
end
