#include "deadpoint/fem/large_pages.hpp"

#include "deadpoint/fem/petsc.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <malloc.h>
#include <memory>
#include <sys/mman.h>
#include <unordered_map>

namespace deadpoint::fem {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;
constexpr std::size_t worth_while = 16 * large_page;  // matrices
constexpr std::size_t vector_alignment = 64;

// Mapped by themselves: malloc would take them from its pool, of small pages used before. One thread calls PETSc.
std::unordered_map<void*, std::size_t>& mapped()
{
    static std::unordered_map<void*, std::size_t> sizes;
    return sizes;
}

// From the start of a large page on, so that it can be one.
void* map_large(std::size_t size)
{
    const std::size_t all = size + large_page;
    void* start = mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (start == MAP_FAILED)
        return nullptr;
    void* aligned = start;
    std::size_t room = all;
    std::align(large_page, size, aligned, room);
    auto* const begin = static_cast<char*>(start);
    auto* const first = static_cast<char*>(aligned);
    const std::size_t page = 4096, end = (size + page - 1) / page * page;
    if (first > begin)
        munmap(begin, static_cast<std::size_t>(first - begin));
    munmap(first + end, static_cast<std::size_t>(begin + all - (first + end)));
    madvise(first, end, MADV_HUGEPAGE);
    mapped()[first] = end;
    return first;
}

PetscErrorCode allocate(std::size_t size, PetscBool clear, int, const char[], const char[], void** result)
{
    *result = nullptr;
    if (size >= worth_while)
        *result = map_large(size);
    else if (size > 0) {
        if (posix_memalign(result, vector_alignment, size) != 0)
            *result = nullptr;
        else if (clear)
            std::memset(*result, 0, size);
    }
    return size > 0 && !*result ? PETSC_ERR_MEM : 0;
}

PetscErrorCode release(void* memory, int, const char[], const char[])
{
    const auto large = mapped().find(memory);
    if (large == mapped().end()) {
        std::free(memory);
        return 0;
    }
    munmap(memory, large->second);
    mapped().erase(large);
    return 0;
}

PetscErrorCode reallocate(std::size_t size, int, const char[], const char[], void** memory)
{
    const auto large = mapped().find(*memory);
    const std::size_t before = large == mapped().end() ? malloc_usable_size(*memory) : large->second;
    void* moved = nullptr;
    if (const auto code = allocate(size, PETSC_FALSE, 0, "", "", &moved))
        return code;
    if (moved && *memory)
        std::memcpy(moved, *memory, std::min(before, size));
    release(*memory, 0, "", "");
    *memory = moved;
    return 0;
}

}  // namespace

void ask_for_large_pages() { PetscMallocSet(allocate, release, reallocate); }

void give_back_freed_memory() { malloc_trim(0); }

}  // namespace deadpoint::fem
