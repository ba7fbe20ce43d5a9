/* umbra serve: the page of sensitivities in a browser, which asks for what its lines do not reach.
 * One connection after the other is served by one thread of libmicrohttpd, on the loopback address
 * alone. */
#include <arpa/inet.h>
#include <math.h>
#include <microhttpd.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <time.h>

#include "app/sensitivity.h"
#include "app/terminal.h"
#include "base/document/schema.h"

#define TOKEN   32    /* characters */
#define BODY    65536 /* [bytes] of a request, at most */
#define REQUEST "the request"

struct server {
  struct um_context *context;
  struct um_app_sensitivity_work work;
  char token[TOKEN + 1];
  char host[2][40]; /* "127.0.0.1:8017", "localhost:8017" */
  char *page;
  size_t page_length;
};

/* A request in the making. */
struct request {
  char *body;
  size_t length;
  bool too_long;
};

static bool make_token(char token[TOKEN + 1])
{
  unsigned char byte[TOKEN / 2];
  if (getrandom(byte, sizeof byte, 0) != (ssize_t)sizeof byte) return false;
  for (size_t i = 0; i < sizeof byte; i++) snprintf(token + 2 * i, 3, "%02x", byte[i]);
  return true;
}

/* In a time that does not tell where they differ. */
static bool is_token(const struct server *s, const char *text)
{
  unsigned char differs = 0;
  if (text == NULL || strlen(text) != TOKEN) return false;
  for (size_t i = 0; i < TOKEN; i++) differs |= (unsigned char)(text[i] ^ s->token[i]);
  return differs == 0;
}

static enum MHD_Result answer(struct MHD_Connection *connection, unsigned code, const char *type,
                              size_t length, char *text, enum MHD_ResponseMemoryMode mode)
{
  struct MHD_Response *response = MHD_create_response_from_buffer(length, text, mode);
  if (response == NULL) return MHD_NO;
  (void)MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, type);
  (void)MHD_add_response_header(response, MHD_HTTP_HEADER_CACHE_CONTROL, "no-store");
  (void)MHD_add_response_header(response, "X-Content-Type-Options", "nosniff");
  (void)MHD_add_response_header(response, "Referrer-Policy", "no-referrer");
  enum MHD_Result result = MHD_queue_response(connection, code, response);
  MHD_destroy_response(response);
  return result;
}

static enum MHD_Result say(struct MHD_Connection *connection, unsigned code, const char *text)
{
  return answer(connection, code, "text/plain; charset=utf-8", strlen(text), (char *)text,
                MHD_RESPMEM_MUST_COPY);
}

/* A page of another origin can make a browser ask, by a name that leads here: Host tells. */
static bool is_from_here(const struct server *s, struct MHD_Connection *connection)
{
  const char *host = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Host");
  const char *origin = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Origin");
  for (int i = 0; i < 2; i++) {
    if (host == NULL || strcmp(host, s->host[i]) != 0) continue;
    return origin == NULL ||
           (strncmp(origin, "http://", 7) == 0 && strcmp(origin + 7, s->host[i]) == 0);
  }
  return false;
}

/* ---- what is computed ---- */

struct values {
  struct um_mark at;
  struct um_schema_list value; /* of struct um_schema_number */
};
struct body {
  struct um_mark at;
  struct values *values;
};
static const struct um_schema_field value_fields[] = {
    UM_FIELD(struct values, value, "PARAMETER", UM_SCHEMA_REST)};
static const struct um_schema_object values_object = {.name = "values",
                                                      .size = sizeof(struct values),
                                                      .fields = value_fields,
                                                      .nfield = UM_FIELD_COUNT(value_fields)};
static const struct um_schema_field body_fields[] = {UM_FIELD(
    struct body, values, "values", UM_SCHEMA_MAP, .required = true, .object = &values_object)};
static const struct um_schema_object body_object = {.name = REQUEST,
                                                    .size = sizeof(struct body),
                                                    .fields = body_fields,
                                                    .nfield = UM_FIELD_COUNT(body_fields)};

static enum um_status find_rows(struct um_context *context, const struct um_sensitivity_matrix *m,
                                const struct um_schema_number *value, size_t n, size_t *row,
                                double *to)
{
  for (size_t i = 0; i < n; i++) {
    size_t at = 0;
    while (at < m->nrow && strcmp(m->row[at].name, value[i].name) != 0) at++;
    if (at == m->nrow)
      return um_core_fail(context, UM_ERR_INPUT, "%.100s: the page has no such parameter",
                          value[i].name);
    row[i] = at;
    to[i] = value[i].value;
  }
  return UM_OK;
}

static void put_curves(const struct um_sensitivity_matrix *m, const double *curves, FILE *file)
{
  fputs("{\"curves\": [", file);
  for (size_t c = 0; c < m->ncurve; c++) {
    um_core_json_text(file, c > 0 ? ",\n{" : "\n{", "name", m->curve[c].name);
    fputs(", \"data\": [", file);
    for (size_t k = 0; k < m->ntime; k++) {
      if (k > 0) fputs(", ", file);
      um_core_json_number(file, curves[c * m->ntime + k]);
    }
    fputs("]}", file);
  }
  fputs("]}\n", file);
}

/* Answer of a body, as text that the caller frees. */
static enum um_status compute(struct server *s, const char *text, char **out, size_t *length)
{
  enum um_status status;
  struct um_context *context = s->context;
  const struct um_sensitivity_matrix *m = s->work.matrix;
  struct um_document *document = NULL;
  void *root = NULL;
  size_t *row = NULL;
  double *to = NULL, *curves = NULL;
  *out = NULL;
  um_core_message_clear(context);
  UM_CHECK(um_document_parse(context, REQUEST, text, &body_object, NULL, 0, &document, &root));
  const struct um_schema_list *list = &((const struct body *)root)->values->value;
  UM_CHECK(um_core_allocate(context, list->count, sizeof *row, &row));
  UM_CHECK(um_core_allocate(context, list->count, sizeof *to, &to));
  UM_CHECK(um_core_allocate(context, m->ncurve * m->ntime, sizeof *curves, &curves));
  UM_CHECK(find_rows(context, m, list->items, list->count, row, to));
  UM_CHECK(um_sensitivity_exact(context, m, row, to, list->count, curves));
  FILE *file = open_memstream(out, length);
  if (file == NULL) UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "out of memory"));
  put_curves(m, curves, file);
  if (fclose(file) != 0) UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "out of memory"));
done:
  um_document_destroy(&document);
  UM_FREE(context, row, to, curves);
  return status;
}

static enum MHD_Result post(struct server *s, struct MHD_Connection *connection,
                            struct request *request)
{
  static const char bearer[] = "Bearer ";
  const char *authorization =
      MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Authorization");
  char *text = NULL;
  size_t length = 0;
  if (authorization == NULL || strncmp(authorization, bearer, sizeof bearer - 1) != 0 ||
      !is_token(s, authorization + sizeof bearer - 1))
    return say(connection, MHD_HTTP_FORBIDDEN, "the token is missing or wrong\n");
  if (request->too_long)
    return say(connection, MHD_HTTP_CONTENT_TOO_LARGE, "the request is too long\n");
  enum um_status status = compute(s, request->body != NULL ? request->body : "", &text, &length);
  if (status == UM_OK)
    return answer(connection, MHD_HTTP_OK, "application/json", length, text, MHD_RESPMEM_MUST_FREE);
  free(text);
  return say(connection,
             status == UM_ERR_INPUT || status == UM_ERR_REFUSED ? MHD_HTTP_BAD_REQUEST
                                                                : MHD_HTTP_INTERNAL_SERVER_ERROR,
             um_core_message(s->context));
}

static enum MHD_Result get(struct server *s, struct MHD_Connection *connection, const char *url)
{
  const char *token = MHD_lookup_connection_value(connection, MHD_GET_ARGUMENT_KIND, "token");
  if (strcmp(url, "/") != 0) return say(connection, MHD_HTTP_NOT_FOUND, "there is one page: /\n");
  if (!is_token(s, token))
    return say(connection, MHD_HTTP_FORBIDDEN,
               "the page is at the address that umbra serve printed, with its token\n");
  return answer(connection, MHD_HTTP_OK, "text/html; charset=utf-8", s->page_length, s->page,
                MHD_RESPMEM_PERSISTENT);
}

/* What arrives of a body; memory that is short reads as a body that is too long. */
static void gather(struct request *request, const char *data, size_t n)
{
  if (request->too_long || request->length + n > BODY) {
    request->too_long = true;
    return;
  }
  char *body = realloc(request->body, request->length + n + 1);
  request->too_long = body == NULL;
  if (body == NULL) return;
  memcpy(body + request->length, data, n);
  request->body = body;
  request->length += n;
  body[request->length] = '\0';
}

static enum MHD_Result handle(void *self, struct MHD_Connection *connection, const char *url,
                              const char *method, const char *version, const char *data,
                              size_t *size, void **kept)
{
  struct server *s = self;
  (void)version;
  if (*kept == NULL) { /* the head has arrived */
    *kept = calloc(1, sizeof(struct request));
    return *kept != NULL ? MHD_YES : MHD_NO;
  }
  if (*size > 0) {
    gather(*kept, data, *size);
    *size = 0;
    return MHD_YES;
  }
  if (!is_from_here(s, connection))
    return say(connection, MHD_HTTP_FORBIDDEN, "this server answers its own page alone\n");
  if (strcmp(method, MHD_HTTP_METHOD_GET) == 0) return get(s, connection, url);
  if (strcmp(method, MHD_HTTP_METHOD_POST) == 0 && strcmp(url, "/compute") == 0)
    return post(s, connection, *kept);
  return say(connection, MHD_HTTP_METHOD_NOT_ALLOWED, "accepted: GET /, POST /compute\n");
}

static void complete(void *self, struct MHD_Connection *connection, void **kept,
                     enum MHD_RequestTerminationCode why)
{
  struct request *request = *kept;
  (void)self;
  (void)connection;
  (void)why;
  if (request != NULL) free(request->body);
  free(request);
  *kept = NULL;
}

/* ---- the command ---- */

static enum um_status make_page(struct server *s, const struct um_app_options *options)
{
  const struct um_sensitivity_report report = {
      .matrix = s->work.matrix, .command = options->command, .version = UM_APP_VERSION};
  FILE *file = open_memstream(&s->page, &s->page_length);
  if (file == NULL) return um_core_fail(s->context, UM_ERR_MEMORY, "out of memory");
  enum um_status status = um_sensitivity_report_serve_page(s->context, &report, s->token, file);
  if (fclose(file) != 0 && status == UM_OK)
    status = um_core_fail(s->context, UM_ERR_MEMORY, "out of memory");
  return status;
}

/* Serve until a signal comes. */
static enum um_status serve(struct server *s, int port, bool json)
{
  struct sockaddr_in address = {.sin_family = AF_INET,
                                .sin_port = htons((uint16_t)port),
                                .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
  struct MHD_Daemon *daemon = MHD_start_daemon(
      MHD_USE_INTERNAL_POLLING_THREAD, (uint16_t)port, NULL, NULL, handle, s, MHD_OPTION_SOCK_ADDR,
      (struct sockaddr *)&address, MHD_OPTION_NOTIFY_COMPLETED, complete, NULL,
      MHD_OPTION_CONNECTION_LIMIT, 8U, MHD_OPTION_CONNECTION_TIMEOUT, 60U, MHD_OPTION_END);
  if (daemon == NULL)
    return um_core_fail(s->context, UM_ERR_IO,
                        "port %d of this machine cannot be had; accepted: --port with another one",
                        port);
  const union MHD_DaemonInfo *info = MHD_get_daemon_info(daemon, MHD_DAEMON_INFO_BIND_PORT);
  unsigned bound = info != NULL ? info->port : (unsigned)port;
  snprintf(s->host[0], sizeof s->host[0], "127.0.0.1:%u", bound);
  snprintf(s->host[1], sizeof s->host[1], "localhost:%u", bound);
  um_app_terminal_clear();
  printf(json ? "{\"address\": \"http://%s/?token=%s\"}\n"
              : "open http://%s/?token=%s\nCtrl-C ends it\n",
         s->host[0], s->token);
  fflush(stdout);
  while (!um_core_stopped(s->context))
    (void)nanosleep(&(struct timespec){.tv_nsec = 100000000}, NULL);
  MHD_stop_daemon(daemon);
  return UM_OK;
}

int um_app_serve(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct server s = {.context = context};
  UM_CHECK(um_app_sensitivity_begin(context, options, &s.work));
  UM_CHECK(um_app_sensitivity_compute(context, options, &s.work));
  if (!make_token(s.token))
    UM_CHECK(um_core_fail(context, UM_ERR_LIBRARY, "no random numbers for a token"));
  UM_CHECK(make_page(&s, options));
  UM_CHECK(serve(&s, options->port, options->json));
done:
  free(s.page);
  um_app_sensitivity_release(context, &s.work);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
