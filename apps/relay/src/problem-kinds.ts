/**
 * Every kind of problem that the relay answers with: its HTTP status and title, and the text of its
 * page at `/problems/KIND`, to which `type` in a problem document leads.
 */

export interface ProblemText {
  status: number;
  title: string;
  /** what happened to the request */
  what: string;
  /** the usual causes */
  why: string;
  /** what to do, first the likeliest */
  fix: readonly string[];
}

/** By the last part of `type`. Texts are Markdown of one line. */
export const problemKinds = {
  "bad-request": {
    status: 400,
    title: "The request cannot be read",
    what: "The relay did not accept the request, and did nothing.",
    why: "A field of the body, the query or a header is missing, has another type, or is out of its range. The answer lists each wrong field in `errors`, with `path`, `found` and `expected`.",
    fix: [
      "Read `errors`: `expected` says what the field must be.",
      "Compare the request with [the reference](/docs/http). Do not send the same request again.",
    ],
  },
  "not-authorised": {
    status: 401,
    title: "A valid key is missing",
    what: "The relay did not accept the request, because it has no key that counts.",
    why: "The header `Authorization: Bearer KEY` is missing, the key has a typing error, or the owner has revoked it.",
    fix: [
      "Send the part of the address after the `#` as the key: `Authorization: Bearer drv_...`.",
      "On a command line, put the address in quotes: without them the shell drops the key.",
      "Copy the address again from **Remote** on the robot's page. **New key** there ends the old address.",
    ],
  },
  forbidden: {
    status: 403,
    title: "This key does not allow that",
    what: "The key is valid, but may not make this request.",
    why: "A watch key (`wch_...`) reads and sends no commands. Some calls need the owner key, which only the robot's page has. Only the key that sent a command takes it back.",
    fix: [
      "To drive, use the address of **Remote**, whose key begins with `drv_`.",
      "To end the command of somebody else, send `stop`.",
    ],
  },
  blocked: {
    status: 403,
    title: "This script is blocked",
    what: "The robot's owner has blocked this script. All of its requests are refused.",
    why: "The owner pressed **Block** beside the script under **Remote**, **More**.",
    fix: ["Ask the owner to press **Unblock** there, then start the script again."],
  },
  "pairing-refused": {
    status: 403,
    title: "The robot's owner said no",
    what: "The owner did not let this script drive.",
    why: "The owner pressed **No** on the robot's page.",
    fix: ["Ask them, and pair again with a new code."],
  },
  "not-found": {
    status: 404,
    title: "There is nothing here",
    what: "No page and no call has this address.",
    why: "The path has a typing error or a part is missing.",
    fix: [
      "Compare the path with [the reference](/docs/http). Calls to a robot begin with `/api/v1/robots/ID`.",
    ],
  },
  "no-robot": {
    status: 404,
    title: "There is no such robot",
    what: "The relay knows no robot with the id in the address.",
    why: "A robot is deleted 2 hours after its last use, 24 hours after its page registered it, and when its owner deletes it.",
    fix: ["Open the robot's page, choose **Remote** and copy the new address."],
  },
  "no-connection": {
    status: 404,
    title: "This connection is closed",
    what: "The long-poll connection does not exist any more.",
    why: "It was silent for too long, or the relay was restarted.",
    fix: ["Open a new connection with `POST /long-poll`."],
  },
  "no-document": {
    status: 404,
    title: "There is no such short link",
    what: "No document is stored under this code.",
    why: "The code has a typing error, the document was deleted, or nobody has used it for 180 days.",
    fix: ["Check each letter of the code.", "Ask for a new link."],
  },
  "no-key": {
    status: 404,
    title: "There is no such key",
    what: "The robot has no key with this id.",
    why: "The key was revoked, or its id has a typing error.",
    fix: ["List the keys with `GET /keys`."],
  },
  "no-pairing": {
    status: 404,
    title: "This pairing code does not count",
    what: "No robot's page displays this code.",
    why: "The code has a typing error, is older than 10 minutes, or was taken back by the page.",
    fix: [
      "Check each letter. A code has 8 of them, all consonants.",
      "Make a new code under **Remote** on the robot's page.",
    ],
  },
  "no-script": {
    status: 404,
    title: "There is no such script",
    what: "The robot's owner has blocked no script with this id.",
    why: "The script was unblocked already, or its key was revoked.",
    fix: ["List the scripts with `GET /scripts`."],
  },
  "no-maze": {
    status: 404,
    title: "The robot's maze is not known",
    what: "The relay has no maze of this robot.",
    why: "The robot's page has not connected yet, or the robot is a physical one that knows no maze.",
    fix: [
      "Open the robot's page, choose **Remote** and try again.",
      "Drive by the sensors alone, as the [wall follower](/docs/recipes#wall-follower-that-stops-at-the-goal) does.",
    ],
  },
  "no-command": {
    status: 404,
    title: "There is no such command",
    what: "The robot has no command with this number.",
    why: "`SEQ` has a typing error, or the command has ended and is older than the newest 10,000.",
    fix: [
      "Use `seq` from the answer to `POST /commands`.",
      "List the commands with `GET /commands`.",
    ],
  },
  "method-not-allowed": {
    status: 405,
    title: "This address does not know the method",
    what: "The address exists, but not for this HTTP method.",
    why: "For example, a command was sent with `GET` in place of `POST`.",
    fix: ["Use one of the methods in the header `Allow` of the answer."],
  },
  "too-slow": {
    status: 408,
    title: "The request took too long",
    what: "The relay closed the connection before the request was complete.",
    why: "The headers took more than 10 s or the whole request more than 15 s to arrive.",
    fix: ["Send the request again, with the same `Idempotency-Key` if it is a command."],
  },
  "key-conflict": {
    status: 409,
    title: "The idempotency key was used for another command",
    what: "The command was not stored.",
    why: "Another command of this robot has the same `Idempotency-Key`.",
    fix: [
      "Make a new random key for each command. Use a key again only to send the same command again.",
    ],
  },
  "code-used": {
    status: 409,
    title: "This pairing code was used",
    what: "The owner was not asked.",
    why: "Another script has asked by this code. A code is for one script.",
    fix: ["Make a new code under **Remote** on the robot's page."],
  },
  "driving-paused": {
    status: 409,
    title: "Remote driving is paused",
    what: "The command was not stored.",
    why: "The owner pressed **Pause scripts** under **Remote**. Reading still works, and so does `stop`.",
    fix: [
      "Press **Let scripts drive** on the robot's page.",
      "Send the command again, about once a second, until it is accepted.",
    ],
  },
  "no-snapshot": {
    status: 409,
    title: "The robot has not reported yet",
    what: "There are no sensor readings to answer with.",
    why: "The robot's page has registered the robot and has not connected.",
    fix: [
      "Open the robot's page and choose **Remote**.",
      "Wait for the first report: `GET /sensors?wait=25`.",
    ],
  },
  "nothing-to-replace": {
    status: 409,
    title: "The key to replace is not there",
    what: "No key was made.",
    why: "The robot has no key of this kind with the id in `replace`.",
    fix: ["List the keys with `GET /keys`, or make the key without `replace`."],
  },
  "unknown-driver": {
    status: 409,
    title: "The script's key is not known",
    what: "The script was not blocked.",
    why: "The robot has no driver key with the id in `driver`: the owner has revoked it, or the id has a typing error.",
    fix: ["List the scripts with `GET /scripts`. A script whose key is revoked cannot come back."],
  },
  "no-question": {
    status: 409,
    title: "The question is over",
    what: "The answer was not stored.",
    why: "No script asks with the `id` in the body: it was answered, the code was taken back, or its 10 minutes are over.",
    fix: ["Make a new code under **Remote** on the robot's page, and let the script ask again."],
  },
  "too-many-keys": {
    status: 409,
    title: "The robot has too many keys",
    what: "No key was made.",
    why: "A robot has at most 12 keys.",
    fix: ["Revoke a key that nobody uses, then try again."],
  },
  "too-many-blocked": {
    status: 409,
    title: "Too many scripts are blocked",
    what: "The script was not blocked.",
    why: "At most 16 scripts of a robot are blocked at a time.",
    fix: ["Unblock a script.", "Make a new key: it ends all scripts of the old one."],
  },
  "too-large": {
    status: 413,
    title: "The body is too large",
    what: "The relay did not read the body to its end.",
    why: "A document of a short link and the maze of a robot have at most 64 KiB, every other body 16 KiB.",
    fix: ["Send less. Do not send the same request again."],
  },
  "not-json": {
    status: 415,
    title: "The body is not JSON",
    what: "The relay did not read the body.",
    why: "The header `Content-Type` says something else, or the body is compressed.",
    fix: ["Send plain JSON in UTF-8 with `Content-Type: application/json`."],
  },
  "wrong-host": {
    status: 421,
    title: "This service has another name",
    what: "The relay does not answer under the name in the header `Host`.",
    why: "The name of the service has changed, or its operator has not listed this name.",
    fix: [
      "Use the address that the service prints at its start.",
      "If you run the service, add the name to `ALLOWED_HOSTS`.",
    ],
  },
  "too-late": {
    status: 422,
    title: "The command came too late",
    what: "The command was not stored, so the robot never does it.",
    why: "The network held it up for longer than its time to live, `ttl`. That is 10 s if the command does not say otherwise.",
    fix: [
      "Read the sensors: the robot may stand elsewhere now. Then send a new command, with a new key.",
      "Choose a longer `ttl` if the network is slow. It must be longer than the round trip.",
    ],
  },
  "queue-full": {
    status: 429,
    title: "Too many commands wait",
    what: "The command was not stored.",
    why: "64 commands wait at this robot.",
    fix: [
      "Wait until a command has ended: `GET /commands/SEQ?wait=25`. Then send this one again.",
      "Send the next command only after the one before has ended.",
    ],
  },
  "too-fast": {
    status: 429,
    title: "Too many requests",
    what: "The relay did not do what was asked.",
    why: "A key sends at most 20 commands and 5 stops a second. Registrations, short links and pairing codes have limits for each network.",
    fix: ["Wait for the seconds in the header `Retry-After`, then send the same request again."],
  },
  "too-many-readers": {
    status: 429,
    title: "Too many connections",
    what: "The relay did not open another connection, or did not wait.",
    why: "60 may read a robot at once, requests that wait included. There is a limit for each key and network, too.",
    fix: [
      "End scripts that you do not need.",
      "Wait for the seconds in `Retry-After`, then try again.",
    ],
  },
  "headers-too-large": {
    status: 431,
    title: "The headers are too large",
    what: "The relay did not read the request.",
    why: "Address and headers have more than 8 KiB together.",
    fix: ["Send fewer or shorter headers, and put data into the body."],
  },
  internal: {
    status: 500,
    title: "The relay made a mistake",
    what: "The request failed because of an error in the relay.",
    why: "The relay's log has the details.",
    fix: [
      "Send the request again in a moment, with the same `Idempotency-Key`.",
      "If it fails again, tell the operator of the service.",
    ],
  },
  "page-not-built": {
    status: 503,
    title: "The page has not been built",
    what: "The service runs, but has no page to send.",
    why: "The relay was started without a build.",
    fix: ["If you run the service: `npm run build`. `npm start` does both."],
  },
  restarting: {
    status: 503,
    title: "The relay is being restarted",
    what: "The relay takes no requests at the moment.",
    why: "The operator restarts the service. Robots and commands are stored.",
    fix: ["Send the same request again after the seconds in `Retry-After`."],
  },
  "no-store": {
    status: 503,
    title: "The relay's store does not answer",
    what: "The relay could not read or store what was asked for.",
    why: "The database is unavailable for a moment.",
    fix: [
      "Send the same request again after the seconds in `Retry-After`, with the same `Idempotency-Key`.",
    ],
  },
  "storage-full": {
    status: 507,
    title: "The relay's disk is full",
    what: "Nothing was stored.",
    why: "The disk of the service has no room.",
    fix: ["Try again in a minute.", "If you run the service, make room: it goes on by itself."],
  },
} as const satisfies Record<string, ProblemText>;

export type ProblemKind = keyof typeof problemKinds;
