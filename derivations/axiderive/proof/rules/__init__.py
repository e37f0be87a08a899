"""What has to be shown for each quantity of each physics."""
