/**
 * Every kind of problem that the relay returns: its HTTP status, its title, and the text of its
 * page. The `type` in a problem document points to that page, `/problems/KIND`.
 */
import { accessProblems } from "@corridor/protocol";
import type { ProblemText } from "./problem-text.ts";

/** By the last part of `type`. */
export const problemKinds = {
  "bad-request": {
    status: 400,
    title: "Invalid request",
    what: "The relay rejected the request and changed nothing.",
    why: "A field of the body, the query or a header is missing, has the wrong type, or is out of range. `errors` lists each invalid field with `path`, `found` and `expected`.",
    fix: [
      "Correct each field in `errors`: `expected` describes a valid value.",
      "Compare the request with [the documentation](/docs/commands) and [openapi.json](/openapi.json). Do not send the same request again.",
    ],
  },
  "not-authorised": {
    ...accessProblems["not-authorised"],
    what: "The relay rejected the request because it contains no valid key.",
    why: "The header `Authorization: Bearer KEY` is missing, the key contains a typing error, or the owner has revoked it. In a class, the key of a student ends when the teacher removes the student.",
    fix: [
      "Send the part of the address after `#` as the key: `Authorization: Bearer drv_...`.",
      "On a command line, quote the address. Without quotes, the shell drops the key.",
      "Under **Remote** on the robot's page, choose **Copy address with key**. **New key** revokes the key of the old address.",
    ],
  },
  forbidden: {
    ...accessProblems.forbidden,
    what: "The key is valid but does not permit this request.",
    why: "A watch key (`wch_...`), which is the key of a watch link, only reads. Some requests require the owner key, which only the robot's page has. Only the key that sent a command can cancel it. In a class, only the teacher's key (`tea_...`) reads students and changes settings.",
    fix: [
      "To drive, use the address of **Remote**. Its key starts with `drv_`.",
      "To end a command of another script, send `stop`.",
    ],
  },
  blocked: {
    ...accessProblems.blocked,
    what: "The relay rejects all requests of this script because the robot's owner has blocked it.",
    why: "The owner pressed **Block** next to the script under **Remote**, **More**.",
    fix: ["Ask the owner to press **Unblock** there, then start the script again."],
  },
  "reset-disabled": {
    status: 403,
    title: "Scripts may not reset the robot",
    what: "The command `reset` was not stored.",
    why: "The owner switched off **Scripts may reset the robot** under **Remote**, **More**.",
    fix: [
      "Ask the owner to switch it on there, or to press **Reset**.",
      "Drive the robot back, or let the script continue from where the robot is.",
    ],
  },
  "pairing-refused": {
    status: 403,
    title: "Pairing declined",
    what: "The robot's owner did not accept this script.",
    why: "The owner pressed **No** on the robot's page.",
    fix: ["Ask the owner, and pair again with a new code."],
  },
  "not-found": {
    status: 404,
    title: "Not found",
    what: "The relay has no page and no endpoint at this path.",
    why: "The path contains a typing error or is incomplete.",
    fix: [
      "Compare the path with [the documentation](/docs/commands). Paths of a robot start with `/api/v1/robots/ID`.",
    ],
  },
  "gateway-disabled": {
    status: 404,
    title: "Gateway switched off",
    what: "This service does not offer the protocol of this URL.",
    why: "The operator has switched it off, with the setting `GATEWAYS`.",
    fix: [
      "Use [the API](/docs/commands), which always works.",
      "If you operate the service, add the gateway to `GATEWAYS`.",
    ],
  },
  "no-robot": {
    ...accessProblems["no-robot"],
    what: "The relay has no robot with this id.",
    why: "The id contains a typing error, or the robot was deleted. A robot is deleted after 2 hours without use, 24 hours after its registration, or by its owner.",
    fix: [
      "Check the id for typing errors.",
      "Open the robot's page, choose **Remote** and copy the address again. If you closed its tab, the page has a new address.",
    ],
  },
  "no-connection": {
    status: 404,
    title: "Connection closed",
    what: "The long-poll connection does not exist any more.",
    why: "The connection had no request for 15 s, or the relay restarted.",
    fix: ["Open a new connection with `POST /long-poll`."],
  },
  "no-document": {
    status: 404,
    title: "Short link not found",
    what: "No document is stored under this code.",
    why: "The code contains a typing error, or the document was deleted. Documents are deleted after 180 days without use.",
    fix: ["Check each letter of the code.", "Ask for a new link."],
  },
  "no-key": {
    status: 404,
    title: "Key not found",
    what: "The robot has no key with this id.",
    why: "The key was revoked, or the id contains a typing error.",
    fix: ["List the keys with `GET /keys`."],
  },
  "no-pairing": {
    status: 404,
    title: "Unknown or expired pairing code",
    what: "No robot has this pairing code.",
    why: "The code contains a typing error, is older than 10 minutes, or was cancelled on the page.",
    fix: [
      "Check each letter. A code has 8 letters, all consonants.",
      "Press **Show a code to type** under **Remote**, **More** on the robot's page.",
    ],
  },
  "no-script": {
    status: 404,
    title: "Script not found",
    what: "The robot has no blocked script with this id.",
    why: "The script was unblocked already, or its key was revoked.",
    fix: ["List the scripts with `GET /scripts`."],
  },
  "no-maze": {
    status: 404,
    title: "Maze not found",
    what: "The relay has no maze of this robot.",
    why: "The robot's page has not connected yet, or a physical robot has no maze.",
    fix: [
      "Open the robot's page, choose **Remote** and try again.",
      "Use only the sensors, as the [wall follower](/docs/recipes#wall-follower-that-stops-at-the-goal) does.",
    ],
  },
  "no-command": {
    status: 404,
    title: "Command not found",
    what: "The robot has no command with this number.",
    why: "`SEQ` contains a typing error, or the command has ended and is older than the newest 10,000.",
    fix: [
      "Use `seq` from the response to `POST /commands`.",
      "List the commands with `GET /commands`.",
    ],
  },
  "no-class": {
    status: 404,
    title: "Class not found",
    what: "The relay has no class with this code or id.",
    why: "The code contains a typing error, the teacher has a new code, or the class has ended. A class ends when the teacher ends it, after 2 hours without use, and 12 hours after its creation.",
    fix: [
      "Check each letter. A code has 6 letters, all consonants.",
      "Ask the teacher for the current code.",
    ],
  },
  "no-student": {
    status: 404,
    title: "Student not found",
    what: "The class has no student with this number.",
    why: "The teacher removed the student, or the number contains a typing error.",
    fix: ["List the students with `GET /classes/ID`."],
  },
  "no-program": {
    status: 404,
    title: "Program not found",
    what: "The relay has no program of this student.",
    why: "The student has not changed a program since joining the class.",
    fix: ["Read it again once the student has changed the program."],
  },
  "method-not-allowed": {
    status: 405,
    title: "Method not allowed",
    what: "The path exists, but does not support this HTTP method.",
    why: "For example, `POST /sensors`: the sensors are read with `GET`. Commands are sent with `POST /commands`.",
    fix: ["Use a method in the header `Allow` of the response."],
  },
  "too-slow": {
    status: 408,
    title: "Request timeout",
    what: "The relay closed the connection before it received the complete request.",
    why: "The headers took more than 10 s to arrive, or the request more than 15 s.",
    fix: ["Send the request again, with the same `Idempotency-Key` if it is a command."],
  },
  "key-conflict": {
    status: 409,
    title: "The idempotency key was used for another command",
    what: "The command was not stored.",
    why: "Another command that this access key sent to the robot has the same `Idempotency-Key`.",
    fix: ["Create a new random key for each command. Repeat a key only to retry the same command."],
  },
  "code-used": {
    status: 409,
    title: "Pairing code already used",
    what: "The request was not sent to the owner.",
    why: "Another script has used this code. A code is for one script.",
    fix: ["Press **Show a code to type** under **Remote**, **More** on the robot's page."],
  },
  "driving-paused": {
    status: 409,
    title: "Remote driving is paused",
    what: "The command was not stored.",
    why: "The owner pressed **Pause scripts** under **Remote**, **More**. Scripts can still read and send `stop`.",
    fix: [
      "Press **Let scripts drive** on the robot's page.",
      "Send the command again about once a second until it is accepted.",
    ],
  },
  "no-snapshot": {
    status: 409,
    title: "No snapshot yet",
    what: "There are no sensor readings to return.",
    why: "The robot is registered, but its page has not connected yet.",
    fix: [
      "Open the robot's page and choose **Remote**.",
      "Wait for the first snapshot: `GET /sensors?wait=25`.",
    ],
  },
  "nothing-to-replace": {
    status: 409,
    title: "The key to replace was not found",
    what: "No key was created.",
    why: "The robot has no key of this kind with the id in `replace`.",
    fix: ["List the keys with `GET /keys`, or create the key without `replace`."],
  },
  "unknown-driver": {
    status: 409,
    title: "Unknown driver key",
    what: "The script was not blocked.",
    why: "The robot has no driver key with the id in `driver`: the owner has revoked it, or the id contains a typing error.",
    fix: ["List the scripts with `GET /scripts`. A script with a revoked key cannot reconnect."],
  },
  "no-question": {
    status: 409,
    title: "No such pairing request",
    what: "The answer was not stored.",
    why: "No pairing request has the `id` in the body: it was answered differently, the code was cancelled, or its 10 minutes have passed.",
    fix: [
      "Press **Show a code to type** under **Remote**, **More** on the robot's page, and pair the script again.",
    ],
  },
  "too-many-keys": {
    status: 409,
    title: "Too many keys",
    what: "No key was created.",
    why: "A robot has at most 12 keys.",
    fix: ["Revoke an unused key, then try again."],
  },
  "too-many-blocked": {
    status: 409,
    title: "Too many blocked scripts",
    what: "The script was not blocked.",
    why: "At most 16 scripts of a robot can be blocked at a time.",
    fix: ["Unblock a script.", "Create a new key: this disconnects all scripts of the old key."],
  },
  "class-locked": {
    status: 409,
    title: "The class is locked",
    what: "The student did not join.",
    why: "The teacher locked the class, or as many students have joined as the teacher expected.",
    fix: [
      "Ask the teacher to unlock the class.",
      "To return to the class on another device, ask the teacher for a return code.",
    ],
  },
  "no-other-name": {
    status: 409,
    title: "The name stays",
    what: "The student keeps the present name.",
    why: "A student can change the name twice, and two students never have the same name.",
    fix: ["Ask the teacher to remove you, then join the class again."],
  },
  "class-full": {
    status: 409,
    title: "The class is full",
    what: "The student did not join.",
    why: "A class has at most 200 students, and at most as many as the teacher has entered names.",
    fix: [
      "Ask the teacher to remove a student who does not take part.",
      "To return to the class on another device, ask the teacher for a return code.",
    ],
  },
  "too-large": {
    status: 413,
    title: "The body is too large",
    what: "The relay did not read the complete body.",
    why: "A shared document, a robot's maze, and a request with a lesson have at most 64 KiB. All other bodies have at most 16 KiB.",
    fix: ["Send a smaller body. Do not send the same request again."],
  },
  "not-json": {
    status: 415,
    title: "The body is not JSON",
    what: "The relay did not read the body.",
    why: "The header `Content-Type` has another value, or the body is compressed.",
    fix: ["Send uncompressed JSON in UTF-8 with `Content-Type: application/json`."],
  },
  "wrong-host": {
    status: 421,
    title: "Unknown host name",
    what: "The relay does not serve the name in the header `Host`.",
    why: "The name of the service has changed, or the operator has not listed this name.",
    fix: [
      "Use the address that the service prints when it starts.",
      "If you operate the service, add the name to `ALLOWED_HOSTS`.",
    ],
  },
  "too-late": {
    status: 422,
    title: "The command arrived too late",
    what: "The command was not stored and never runs.",
    why: "The network delayed the command beyond its time to live, `ttl`. The default is 10 s.",
    fix: [
      "Read the sensors: the robot may have moved. Then send a new command with a new `Idempotency-Key`.",
      "Use a longer `ttl` on a slow network. It must be longer than the round trip.",
    ],
  },
  "not-supported": {
    status: 422,
    title: "The robot cannot do this",
    what: "The command was not stored. Other commands work.",
    why: "The robot's host does not offer the action. For example, a physical robot cannot put itself at its start, so that it rejects `reset`.",
    fix: ["Put the robot there by hand. Let the script continue without this action."],
  },
  "queue-full": {
    status: 429,
    title: "Too many waiting commands",
    what: "The command was not stored.",
    why: "64 commands wait at this robot.",
    fix: [
      "Wait until a command has ended: `GET /commands/SEQ?wait=25`. Then send this command again.",
      "Send the next command only after the previous one has ended.",
    ],
  },
  "too-fast": {
    status: 429,
    title: "Too many requests",
    what: "The relay did not process the request.",
    why: "A key can send 20 commands and 5 stops a second, and a robot accepts one reset a second. Registrations, short links, classes, joins and wrong codes have limits for each network. [Limits](/docs/limits#rate-limits) has all of them.",
    fix: ["Wait for the seconds in the header `Retry-After`, then send the same request again."],
  },
  "too-many-readers": {
    status: 429,
    title: "Too many connections",
    what: "The relay did not open another connection, or did not wait.",
    why: "At most 60 connections and waiting requests can read a robot. Each class, key and network has [a limit](/docs/limits#connections) too.",
    fix: [
      "End scripts that you do not need.",
      "Wait for the seconds in `Retry-After`, then try again.",
    ],
  },
  "headers-too-large": {
    status: 431,
    title: "The headers are too large",
    what: "The relay did not read the request.",
    why: "URL and headers together have more than 8 KiB.",
    fix: ["Send fewer or shorter headers. Send data in the body."],
  },
  internal: {
    status: 500,
    title: "Internal server error",
    what: "The request failed because of an error in the relay.",
    why: "The log of the relay contains the details.",
    fix: [
      "Send the request again in a moment, with the same `Idempotency-Key`.",
      "If it fails again, contact the operator of the service.",
    ],
  },
  "page-not-built": {
    status: 503,
    title: "The page is not built",
    what: "The relay runs, but cannot serve the simulator.",
    why: "The relay was started without a build of the page.",
    fix: ["If you operate the service, run `npm run build`. `npm start` builds and starts."],
  },
  restarting: {
    status: 503,
    title: "The relay is restarting",
    what: "The relay does not accept requests at the moment.",
    why: "The operator restarts the service. Robots and commands are stored.",
    fix: ["Send the same request again after the seconds in `Retry-After`."],
  },
  "no-store": {
    status: 503,
    title: "The store is unavailable",
    what: "The relay could not read or store the data.",
    why: "The database does not respond at the moment.",
    fix: [
      "Send the same request again after the seconds in `Retry-After`, with the same `Idempotency-Key`.",
    ],
  },
  "storage-full": {
    status: 507,
    title: "The disk is full",
    what: "Nothing was stored.",
    why: "The disk of the service is full.",
    fix: [
      "Try again in a minute.",
      "If you operate the service, free disk space. The relay recovers automatically.",
    ],
  },
} as const satisfies Record<string, ProblemText>;

export type ProblemKind = keyof typeof problemKinds;
