import type { Registration, ScriptList } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { makeKey, reportedRobot } from "../../testing/reported-robot.ts";
import {
  callSoap,
  envelopeXml,
  operationXml,
  postSoap,
  type SoapAnswer,
  type SoapOptions,
} from "../../testing/soap-client.ts";
import { startTestRelay, type TestRelay } from "../../testing/test-relay.ts";

const versions = ["1.1", "1.2"] as const;

async function withPage() {
  const parts = await reportedRobot();
  const { relay, robot } = parts;
  /** Calls an operation with the robot's address, or with another. */
  const call = (
    name: string,
    fields: Record<string, unknown> = {},
    options: SoapOptions = {},
  ): Promise<SoapAnswer> =>
    callSoap(relay.origin, name, { robot: robot.address, ...fields }, options);
  /** Runs the next command. */
  const run = async (): Promise<number> => {
    const seq = await parts.start();
    parts.end(seq);
    return seq;
  };
  return { ...parts, call, run };
}

async function soapScripts(relay: TestRelay, robot: Registration): Promise<ScriptList["scripts"]> {
  const answer = await relay.ask(robot, "/scripts", { key: robot.ownerKey });
  const { scripts } = (await answer.json()) as ScriptList;
  return scripts.filter(({ client }) => client === "SOAP");
}

const withoutKey = ({ address }: Registration): string => address.replace(/#.*/, "");

describe.each(versions)("a client of SOAP %s", (version) => {
  const options = { version };

  it("senses, drives, reads the log, cancels and stops", async () => {
    const { call, run, start } = await withPage();
    const sensed = await call("Sense", {}, options);
    expect(sensed).toMatchObject({
      status: 200,
      type: `${version === "1.1" ? "text/xml" : "application/soap+xml"}; charset=utf-8`,
      name: "SenseResponse",
      fields: {
        state: "running",
        "sensors.front": "250.5",
        "pose.heading": "90",
        goalReached: "false",
      },
    });
    expect(sensed.text).not.toContain("null");

    const move = { action: "move", distance: 100, key: "step-0001", wait: 25 };
    const moving = call("Command", move, options);
    expect(await run()).toBe(1);
    const moved = await moving;
    expect(moved).toMatchObject({
      status: 200,
      name: "CommandResponse",
      fields: {
        seq: "1",
        key: "step-0001",
        action: "move",
        "command.distance": "100",
        state: "completed",
        duplicate: "false",
        acceptedAt: expect.stringMatching(/^\d{4}-\d\d-\d\dT[\d:.]+Z$/),
        "pose.x": expect.any(String),
      },
    });
    const again = await call("Command", move, options);
    expect(again.fields).toMatchObject({ seq: "1", state: "completed", duplicate: "true" });

    const sent = await call("Command", { action: "left 90" }, options);
    expect(sent.fields).toMatchObject({ seq: "2", action: "left 90" });
    expect(sent.fields).not.toHaveProperty("reason");
    await start();
    await expect
      .poll(async () => (await call("GetCommand", { seq: 2 }, options)).fields["state"])
      .toBe("started");
    const stopping = call("Stop", { wait: 25 }, options);
    expect(await run()).toBe(3);
    expect((await stopping).fields).toMatchObject({ action: "stop", state: "completed" });
    const log = await call("GetCommands", { after: 1 }, options);
    expect(log.text.match(/<commands>/g)).toHaveLength(2);
    const cancelled = await call("CancelCommand", { seq: 1 }, options);
    expect(cancelled).toMatchObject({ name: "CancelCommandResponse", fields: { seq: "1" } });
  });

  it("reads conditions, in any order of the fields", async () => {
    const { relay, robot, page } = await withPage();
    const condition = "<until><than>60</than><is>&lt;=</is><sensor>front</sensor></until>";
    const left =
      "<until><sensor>left</sensor><is>&gt;</is><than>right</than><plus> 1.5 </plus></until>";
    const fields = `${condition}<action>forward</action>${left}<until><goal>1</goal></until><robot>
      ${robot.address}
    </robot><ttl>1E4</ttl>`;
    const sent = await callSoap(relay.origin, "Command", fields, options);
    expect(sent.status).toBe(200);
    const { command } = await page.next("command");
    expect(command).toEqual({
      action: "forward",
      until: [
        { sensor: "front", is: "<=", than: 60 },
        { sensor: "left", is: ">", than: "right", plus: 1.5 },
        { goal: true },
      ],
    });
    const again = await callSoap(
      relay.origin,
      "GetCommand",
      { robot: robot.address, seq: 1 },
      options,
    );
    expect(again.text).toContain("<until><sensor>front</sensor><is>&lt;=</is><than>60</than>");
  });

  it("receives a typed fault for what the relay refuses", async () => {
    const { call } = await withPage();
    const fault = await call("Command", { action: "move", distance: 90_000 }, options);
    expect(fault).toMatchObject({ status: version === "1.1" ? 500 : 400, name: "Fault" });
    const detail = version === "1.1" ? "detail" : "Detail";
    expect(fault.fields).toMatchObject({
      [version === "1.1" ? "faultcode" : "Code.Value"]:
        version === "1.1" ? "soap:Client" : "soap:Sender",
      [version === "1.1" ? "faultstring" : "Reason.Text"]:
        "Invalid command. distance: found 90000, expected a distance in cm from -25600 to 25600.",
      [`${detail}.RobotFault.code`]: "bad-request",
      [`${detail}.RobotFault.detail`]: expect.stringContaining("distance: found 90000"),
      [`${detail}.RobotFault.errors.path`]: "distance",
    });
    const gone = await call("GetCommand", { seq: 9 }, options);
    expect(gone.fields).toMatchObject({ [`${detail}.RobotFault.code`]: "no-command" });
  });

  it("receives a fault with the code of the envelope that is refused", async () => {
    const { relay, robot } = await withPage();
    const header = (attributes: string, actor = ""): string =>
      `<s:Header><t:Transaction xmlns:t="urn:t" ${attributes} ${actor}/></s:Header>`;
    const sense = operationXml("Sense", { robot: robot.address });
    const post = async (head: string): Promise<SoapAnswer> =>
      postSoap(relay.origin, envelopeXml(sense, version, head), options);
    const code = version === "1.1" ? "faultcode" : "Code.Value";
    const must = await post(header('s:mustUnderstand="1"'));
    expect(must).toMatchObject({ status: 500, fields: { [code]: "soap:MustUnderstand" } });
    expect(must.text).toContain("Envelope.Header.Transaction: found the namespace urn:t");
    expect(must.text).not.toMatch(/detail/i);
    const other = version === "1.1" ? 's:actor="urn:other"' : 's:role="urn:other"';
    expect((await post(header('s:mustUnderstand="1"', other))).status).toBe(200);
    expect((await post(header('s:mustUnderstand="0"'))).status).toBe(200);
    const odd = await post(header('s:mustUnderstand="yes"'));
    expect(odd.text).toContain("expected the value 1 or 0");
    const old = await postSoap(
      relay.origin,
      envelopeXml(sense).replace(/http:[^"]*/, "http://example.org/envelope"),
      options,
    );
    expect(old).toMatchObject({ status: 500, fields: { [code]: "soap:VersionMismatch" } });
    expect(old.text).toContain("Envelope: found the namespace http://example.org/envelope");
  });
});

describe("the version of an answer", () => {
  it("is that of the envelope, whatever the type of its content is", async () => {
    const { relay, robot } = await withPage();
    const sense = operationXml("Sense", { robot: robot.address });
    const answer = await postSoap(relay.origin, envelopeXml(sense, "1.2"), { version: "1.1" });
    expect(answer).toMatchObject({ status: 200, type: "application/soap+xml; charset=utf-8" });
  });
});

describe("a snapshot", () => {
  it("is waited for: the first one, and one that is newer", async () => {
    const { relay, call, page, epoch } = await withPage();
    const seq = (await call("Sense")).fields["seq"];
    const waiting = call("Sense", { after: seq, wait: 25 });
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 2000, line: "default" }) });
    expect((await waiting).fields).toMatchObject({ seq: "2000", line: "default" });
    const silent = await relay.register();
    const none = await call("Sense", { robot: silent.address });
    expect(none.fields).toMatchObject({ "detail.RobotFault.code": "no-snapshot" });
  });

  it("is XML although its page sends characters that XML forbids", async () => {
    const { call, page, epoch } = await withPage();
    const motion = 'a<b>&"\u0000\u001B\uD800\r\n';
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 2000, motion }) });
    const { fields } = await call("Sense", { after: 1999, wait: 25 });
    expect(fields["motion"]).toBe('a<b>&"\uFFFD\uFFFD\uFFFD\r\n');
  });
});

describe("a key", () => {
  it("stands in the header, or in the address; the header takes precedence", async () => {
    const { relay, robot, call } = await withPage();
    const watch = (await makeKey(relay, robot, "watch")).key;
    const inUrl = (await makeKey(relay, robot, "drive", "url")).key;
    const other = await relay.register();
    const code = async (fields: object, options: SoapOptions = {}): Promise<string> =>
      (await call("Stop", { ...fields }, options)).fields["detail.RobotFault.code"] ?? "yes";
    const bare = withoutKey(robot);
    expect(await code({})).toBe("yes");
    expect(await code({ robot: bare }, { key: robot.driverKey })).toBe("yes");
    expect(await code({ robot: `${bare}#` }, { key: robot.driverKey })).toBe("yes");
    expect(await code({}, { key: watch })).toBe("forbidden");
    expect(await code({}, { key: other.driverKey })).toBe("not-authorised");
    expect(await code({ robot: bare })).toBe("not-authorised");
    expect(await code({ robot: `${bare}#${inUrl}` })).toBe("not-authorised");
    expect(await code({ robot: bare }, { key: inUrl })).toBe("not-authorised");
    expect(await code({ robot: `${bare}#${watch}` })).toBe("forbidden");
    expect(await code({ robot: `${bare}#${robot.ownerKey}` })).toBe("forbidden");
    expect(await code({ robot: robot.address.replace(robot.id, "A".repeat(22)) })).toBe("no-robot");
    const sensed = await call("Sense", { robot: `${bare}#${watch}` });
    expect(sensed.status).toBe(200);
  });

  it("is not repeated in the fault if the address is not one", async () => {
    const { robot, call } = await withPage();
    const fault = await call("Sense", { robot: `robot ${robot.driverKey}` });
    expect(fault.text).toContain("robot: found another text, expected the address of a robot");
    expect(fault.text).not.toContain(robot.driverKey);
  });
});

describe("the owner of the robot", () => {
  it("sees the client as SOAP, with the reason of its newest refused command", async () => {
    const { relay, robot, call } = await withPage();
    const refused = await call("Command", { action: "fly" });
    expect(refused.text).toContain("action: found 'fly'");
    const [script] = await soapScripts(relay, robot);
    expect(script?.lastProblem?.detail).toContain("action: found 'fly'");
    await call("Command", { action: "stop", wait: "soon" });
    const named = { headers: { "Script-Name": "Left hand" } };
    await call("Sense", {}, named);
    expect((await soapScripts(relay, robot)).map(({ name }) => name)).toContain("Left hand");
  });

  it("pauses, blocks and revokes a client while it waits", async () => {
    const { relay, robot, page, call } = await withPage();
    const { id, key } = await makeKey(relay, robot, "drive");
    const options = { key };
    const own = { method: "PUT", key: robot.ownerKey };
    await relay.ask(robot, "/pause", own);
    const move = { action: "move", distance: 100 };
    const paused = await call("Command", move, options);
    expect(paused.fields["detail.RobotFault.code"]).toBe("driving-paused");
    await relay.ask(robot, "/pause", { ...own, method: "DELETE" });

    const waiting = call("Command", { ...move, wait: 25 }, options);
    await page.next("command");
    const [script] = await soapScripts(relay, robot);
    const { driver, name, client } = script ?? {};
    const block = { method: "POST", key: robot.ownerKey, body: { driver, name, client } };
    const blocked = (await (await relay.ask(robot, "/blocked", block)).json()) as { id: string };
    const ended = await waiting;
    expect(ended.fields["detail.RobotFault.code"]).toBe("blocked");
    expect(ended.text).toMatch(/Command \d+ was sent before/);
    expect((await call("Sense", {}, options)).fields["detail.RobotFault.code"]).toBe("blocked");
    await relay.ask(robot, `/blocked/${blocked.id}`, { method: "DELETE", key: robot.ownerKey });

    const sensing = call("Sense", { after: 100_000, wait: 25 }, options);
    await call("Sense", {}, options);
    await relay.ask(robot, `/keys/${id}`, { method: "DELETE", key: robot.ownerKey });
    expect((await sensing).fields["detail.RobotFault.code"]).toBe("not-authorised");
  });
});

describe("the URL", () => {
  it.each([
    { query: "?wsdl", binding: "http://schemas.xmlsoap.org/wsdl/soap/" },
    { query: "?WSDL", binding: "http://schemas.xmlsoap.org/wsdl/soap/" },
    { query: "?wsdl=1.2", binding: "http://schemas.xmlsoap.org/wsdl/soap12/" },
  ])("describes the service at $query, with its public URL", async ({ query, binding }) => {
    const relay = await startTestRelay({ config: { publicOrigin: "https://robots.example.org" } });
    const answer = await fetch(`${relay.origin}/soap${query}`);
    expect(answer.status).toBe(200);
    expect(answer.headers.get("content-type")).toBe("text/xml; charset=utf-8");
    expect(answer.headers.get("access-control-allow-origin")).toBeNull();
    const text = await answer.text();
    expect(text).toContain('<soap:address location="https://robots.example.org/soap"/>');
    expect(text).toContain(`xmlns:soap="${binding}"`);
  });

  it.each(["", "?wsdl=2", "?xsd", "?key=wsdl"])("explains itself at %j", async (query) => {
    const relay = await startTestRelay();
    const answer = await fetch(`${relay.origin}/soap${query}`);
    expect(answer.status).toBe(400);
    expect(await answer.json()).toMatchObject({ detail: expect.stringContaining("?wsdl") });
  });

  it.each(["PUT", "DELETE", "OPTIONS"])("answers %s with 405, without CORS", async (method) => {
    const relay = await startTestRelay();
    const answer = await fetch(`${relay.origin}/soap`, {
      method,
      headers: { Origin: "https://example.org" },
    });
    expect(answer.status).toBe(405);
    expect(answer.headers.get("allow")).toBe("GET, POST");
    expect(answer.headers.get("access-control-allow-origin")).toBeNull();
  });

  it("is answered with a sentence if the operator has switched the gateway off", async () => {
    const relay = await startTestRelay({ config: { gateways: ["ros", "mcp"] } });
    for (const method of ["GET", "POST"]) {
      const answer = await fetch(`${relay.origin}/soap?wsdl`, { method });
      expect(answer.status).toBe(404);
      expect(await answer.json()).toMatchObject({ type: "/problems/gateway-disabled" });
    }
  });
});
