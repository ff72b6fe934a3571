"""What several scripts share, and the tests in tests/scripts check."""
