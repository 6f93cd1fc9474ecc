// SPDX-License-Identifier: MIT
// The end of what begin_counted.hpp begins.
#undef reciprocal
#undef wide_reciprocal
#undef integer_root
#undef reciprocal_root
#undef arcspan
#undef std
