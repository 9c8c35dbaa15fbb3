"""The worlds of the course: scenarios, bearings, homing, navigation, video, recordings."""
