#include "deadpoint/fem/algebra/huge_pages.hpp"

#include "deadpoint/fem/algebra/petsc.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <malloc.h>
#include <memory>
#include <sys/mman.h>
#include <unistd.h>
#include <unordered_map>

namespace deadpoint::fem {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;
constexpr std::size_t worth_while = 16 * large_page;  // smallest size that uses large pages: matrices
constexpr std::size_t vector_alignment = 64;

// Sizes of arrays that are mapped directly: malloc would take them from its pool of small pages that were used before.
std::unordered_map<void*, std::size_t>& mapped()
{
    static std::unordered_map<void*, std::size_t> sizes;
    return sizes;
}

// Starts at the boundary of a large page, so that the kernel can use one.
void* map_large(std::size_t size)
{
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t wanted = (size + page - 1) / page * page, all = wanted + large_page;
    void* start = mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (start == MAP_FAILED)
        return nullptr;
    void* aligned = start;
    std::size_t room = all;
    std::align(large_page, wanted, aligned, room);
    const auto before = static_cast<std::size_t>(static_cast<char*>(aligned) - static_cast<char*>(start));
    if (before > 0)
        munmap(start, before);
    if (before < large_page)
        munmap(static_cast<char*>(aligned) + wanted, large_page - before);
    madvise(aligned, wanted, MADV_HUGEPAGE);
    mapped()[aligned] = wanted;
    return aligned;
}

PetscErrorCode petsc_allocate(std::size_t size, PetscBool clear, int, const char[], const char[], void** result)
{
    *result = allocate_array(size);
    if (size > 0 && !*result)
        return PETSC_ERR_MEM;
    if (clear && size < worth_while && size > 0)
        std::memset(*result, 0, size);
    return 0;
}

PetscErrorCode petsc_release(void* memory, int, const char[], const char[])
{
    release_array(memory);
    return 0;
}

PetscErrorCode petsc_resize(std::size_t size, int, const char[], const char[], void** memory)
{
    void* resized = resize_array(*memory, size);
    if (size > 0 && !resized)
        return PETSC_ERR_MEM;
    *memory = resized;
    return 0;
}

}  // namespace

void* allocate_array(std::size_t size)
{
    if (size >= worth_while)
        return map_large(size);
    void* array = nullptr;
    return size > 0 && posix_memalign(&array, vector_alignment, size) == 0 ? array : nullptr;
}

void release_array(void* array)
{
    const auto large = mapped().find(array);
    if (large == mapped().end()) {
        std::free(array);
        return;
    }
    munmap(array, large->second);
    mapped().erase(large);
}

void* resize_array(void* array, std::size_t size)
{
    const auto large = mapped().find(array);
    const std::size_t before = large == mapped().end() ? malloc_usable_size(array) : large->second;
    void* resized = allocate_array(size);
    if (size > 0 && !resized)
        return nullptr;
    if (resized && array)
        std::memcpy(resized, array, std::min(before, size));
    release_array(array);
    return resized;
}

void ask_for_large_pages() { PetscMallocSet(petsc_allocate, petsc_release, petsc_resize); }

void give_back_freed_memory() { malloc_trim(0); }

}  // namespace deadpoint::fem
