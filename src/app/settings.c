#include "settings.h"

#define SCHEMA_ID "io.github.hull2vd.Hull2VD"

static gboolean
runs_from_build (void)
{
  g_autofree char *program = g_file_read_link ("/proc/self/exe", NULL);

  return program != NULL && g_str_has_prefix (program, HULL2VD_BUILD "/");
}

static GSettingsSchema *
find_schema (void)
{
  GSettingsSchemaSource *installed = g_settings_schema_source_get_default ();
  g_autoptr (GSettingsSchemaSource) built = NULL;

  if (runs_from_build ())
    built = g_settings_schema_source_new_from_directory (
        HULL2VD_BUILD "/ui", installed, FALSE, NULL);
  if (built != NULL)
    return g_settings_schema_source_lookup (built, SCHEMA_ID, TRUE);
  if (installed != NULL)
    return g_settings_schema_source_lookup (installed, SCHEMA_ID, TRUE);
  return NULL;
}

GSettings *
settings_new (void)
{
  g_autoptr (GSettingsSchema) schema = find_schema ();

  return schema == NULL ? NULL : g_settings_new_full (schema, NULL, NULL);
}
