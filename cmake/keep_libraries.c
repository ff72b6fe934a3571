/* Linked in by DEADPOINT_SANITIZE alone: libraries stay loaded, so that what they lose is reported under their names. */
int dlclose(void* handle)
{
    (void)handle;
    return 0;
}
