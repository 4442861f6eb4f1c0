/* A micromouse program for mms: follows the wall on the left to the centre. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *ask(const char *command) {
  static char response[64];
  printf("%s\n", command);
  fflush(stdout);
  if (fgets(response, sizeof response, stdin) == NULL) exit(1);
  response[strcspn(response, "\r\n")] = '\0';
  return response;
}

static int is(const char *command, const char *expected) {
  return strcmp(ask(command), expected) == 0;
}

static int is_middle(int at, int size) { return at == size / 2 || at == (size - 1) / 2; }

int main(void) {
  static const int dx[] = {0, 1, 0, -1};
  static const int dy[] = {1, 0, -1, 0};
  int width = atoi(ask("mazeWidth"));
  int height = atoi(ask("mazeHeight"));
  int x = 0, y = 0, heading = 0;
  while (!(is_middle(x, width) && is_middle(y, height))) {
    printf("setColor %d %d c\n", x, y);
    if (is("wallLeft", "false")) {
      ask("turnLeft");
      heading = (heading + 3) % 4;
    }
    while (is("wallFront", "true")) {
      ask("turnRight90");
      heading = (heading + 1) % 4;
    }
    if (!is("moveForward", "ack")) return 1;
    x += dx[heading];
    y += dy[heading];
  }
  fprintf(stderr, "turns %s\n", ask("getStat total-turns"));
  return 0;
}
