// Links the part of the library that needs neither meshes nor fields.
#include <cstdio>
#include <deadpoint/version.hpp>

int main()
{
    const auto linked = deadpoint::library_version();
    std::printf("compiled with deadpoint %s, linked with %s\n", deadpoint::version.data(), linked.data());
    return linked == deadpoint::version ? 0 : 1;
}
