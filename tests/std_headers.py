"""Which standard header declares which name of namespace std.

The first header of a row is the one to include; the others of the row declare
the names, too, by the words of the standard or because they are made of them.
size_t is missing on purpose: every container brings it.
"""
import re

NAMES_OF_HEADERS = {
    "algorithm": "adjacent_find all_of any_of binary_search clamp copy copy_if copy_n count count_if equal fill fill_n find find_first_of find_if"
                 " for_each generate includes inplace_merge is_sorted lexicographical_compare lower_bound max max_element merge min"
                 " min_element minmax minmax_element none_of nth_element partial_sort partition remove remove_if replace reverse"
                 " rotate set_difference set_intersection set_union shuffle sort stable_partition stable_sort transform unique"
                 " upper_bound",
    "array": "array",
    "cctype": "isalnum isalpha isdigit isspace tolower toupper",
    "charconv": "from_chars to_chars",
    "chrono": "chrono",
    "cmath": "acos asin asinh atan atan2 cbrt ceil copysign cos cosh exp expm1 fabs floor fma fmod frexp hypot isfinite isinf isnan ldexp log"
             " log10 log1p log2 lround nan nearbyint pow remainder round sin sinh sqrt tan tanh trunc",
    "cmath cstdlib": "abs",
    "csignal": "sig_atomic_t signal",
    "cstdint": "int16_t int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t",
    "cstdio": "fclose FILE fopen fprintf perror printf rename snprintf",
    "cstdlib": "abort atof atoi atol exit getenv strtod strtol system",
    "cstring": "memcmp memcpy memset strcmp strerror strlen",
    "deque": "deque",
    "exception stdexcept": "current_exception exception exception_ptr rethrow_exception set_terminate terminate uncaught_exceptions",
    "filesystem": "filesystem",
    "fstream": "filebuf fstream ifstream ofstream",
    "functional": "bind function greater hash less plus ref reference_wrapper",
    "initializer_list": "initializer_list",
    "iomanip": "put_time quoted setfill setprecision setw",
    "ios iomanip iostream istream ostream sstream fstream": "defaultfloat fixed hexfloat ios ios_base left right scientific streamsize",
    "iostream": "cerr cin clog cout",
    "istream iostream iosfwd sstream fstream": "istream",
    "istream iostream sstream fstream": "ws",
    "iterator": "back_inserter distance inserter istreambuf_iterator make_move_iterator next ostream_iterator prev advance",
    "limits": "numeric_limits",
    "list": "list",
    "map": "map multimap",
    "memory": "dynamic_pointer_cast enable_shared_from_this make_shared make_unique shared_ptr static_pointer_cast unique_ptr"
              " weak_ptr",
    "mutex": "lock_guard mutex",
    "new": "bad_alloc nothrow",
    "numeric": "accumulate gcd inner_product iota partial_sum",
    "optional": "make_optional nullopt optional",
    "ostream iostream sstream fstream": "endl flush",
    "ostream iostream iosfwd sstream fstream": "ostream",
    "queue": "priority_queue queue",
    "random": "mt19937 normal_distribution random_device uniform_int_distribution uniform_real_distribution",
    "regex": "regex regex_match regex_replace regex_search smatch sregex_iterator",
    "set": "multiset set",
    "sstream iosfwd": "istringstream ostringstream stringbuf stringstream",
    "stdexcept": "invalid_argument logic_error out_of_range runtime_error",
    "streambuf": "streambuf",
    "string": "getline stod stoi stol stoul string to_string",
    "string_view": "string_view",
    "system_error filesystem": "error_code",
    "system_error charconv": "errc",
    "tuple": "apply get get_tuple make_tuple tie tuple",
    "type_traits": "conditional_t decay_t enable_if_t false_type integral_constant invoke_result_t is_same is_same_v true_type"
                   " underlying_type_t",
    "typeinfo": "type_info",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "utility": "declval exchange forward make_pair move pair swap",
    "variant": "get_if holds_alternative monostate variant visit",
    "vector": "vector",
}
HEADERS_OF = {name: row.split() for row, names in NAMES_OF_HEADERS.items() for name in names.split()}
USE = re.compile(r"\bstd::([a-z_0-9A-Z]+)")
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"([a-z]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.DOTALL)
INCLUDED = re.compile(r"^[ \t]*#[ \t]*include[ \t]*<([a-z_]+)>", re.MULTILINE)


def missing_headers(text, given=""):
    """{header: a name that needs it} for the source TEXT; what GIVEN includes counts as included."""
    included = set(INCLUDED.findall(text)) | set(INCLUDED.findall(given))
    missing = {}
    for name in USE.findall(COMMENT_OR_TEXT.sub(" ", text)):
        headers = HEADERS_OF.get(name, [])
        if headers and not included.intersection(headers):
            missing.setdefault(headers[0], name)
    return missing


def unknown_names(text):
    """Names of namespace std that the table does not have."""
    return sorted(set(USE.findall(COMMENT_OR_TEXT.sub(" ", text))) - set(HEADERS_OF) - {"size_t"})
