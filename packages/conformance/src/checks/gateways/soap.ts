/** The gateway for SOAP clients: one service for all robots of a host. */
import { sensorNames } from "@corridor/protocol";
import type { CheckGroup } from "../../check.ts";
import type { Host } from "../../host.ts";
import { must } from "../../mismatch.ts";
import { isNear, moved, moveToStart, mustHaveReadings, readings } from "../../pen.ts";

const NAMESPACE = "urn:corridor:robot:1";
const operations = ["Sense", "Command", "GetCommand", "GetCommands", "CancelCommand", "Stop"];

export const soap: CheckGroup = {
  title: "SOAP gateway",
  gateway: "soap",
  checks: [
    {
      promise: "soap-wsdl",
      name: "?wsdl describes the operations, at the public URL of the service",
      run: async (host) => {
        const url = host.gatewayUrl("soap");
        const { status, text } = await host.requestUrl(`${url}?wsdl`, { key: null });
        must(status === 200, "200 for ?wsdl", `${status} ${text}`);
        must(text.includes(`targetNamespace="${NAMESPACE}"`), `the namespace ${NAMESPACE}`, text);
        for (const name of operations) {
          must(text.includes(`operation name="${name}"`), `the operation ${name}`, text);
        }
        const location = /:address\s[^>]*?location="([^"]*)"/.exec(text)?.[1];
        must(location === url, `the address ${url}`, location ?? "none");
      },
    },
    {
      promise: "soap-sense",
      name: "Sense answers with the readings in cm",
      run: async (host) => {
        const expected = await readings(host);
        const { status, text } = await post(host, "Sense");
        must(status === 200, "200 for Sense", `${status} ${text}`);
        const sensors = textOf(text, "sensors");
        for (const side of sensorNames) {
          const found = Number(textOf(sensors, side));
          must(isNear(found, expected[side]), `${side} about ${expected[side]}`, found);
        }
      },
    },
    {
      promise: "soap-command",
      name: "Command with `wait` answers with the record of the ended command",
      run: async (host) => {
        await moveToStart(host);
        const before = await readings(host);
        const order = "<action>move</action><distance>60</distance><wait>25</wait>";
        const { status, text } = await post(host, "Command", order);
        must(status === 200, "200 for Command", `${status} ${text}`);
        const state = textOf(text, "state");
        must(state === "completed", "the state completed", state);
        await mustHaveReadings(host, moved(before, 60), "after one move of 60 cm");
      },
    },
    {
      promise: "soap-fault",
      name: "a wrong key in the robot's address is a typed fault with status 500",
      run: async (host) => {
        const { status, text } = await post(host, "Stop", "", host.addressWith(host.wrongKey));
        must(status === 500, "500 for a wrong key", status);
        const fault = textOf(text, "RobotFault");
        const code = textOf(fault, "code");
        must(code === "not-authorised", "the code not-authorised in RobotFault", code);
        must(textOf(fault, "detail") !== "", "a sentence in RobotFault", fault);
        must(!text.includes(host.wrongKey), "a fault without the key", text);
      },
    },
  ],
};

/** Calls an operation with the key in the robot's address. */
async function post(host: Host, operation: string, fields = "", address = host.addressWith()) {
  const body = `<${operation} xmlns="${NAMESPACE}"><robot>${address}</robot>${fields}</${operation}>`;
  return host.requestUrl(host.gatewayUrl("soap"), {
    method: "POST",
    key: null,
    headers: { "Content-Type": "text/xml; charset=utf-8", SOAPAction: '""' },
    body: `<?xml version="1.0" encoding="utf-8"?><s:Envelope xmlns:s="http://schemas.xmlsoap.org/soap/envelope/"><s:Body>${body}</s:Body></s:Envelope>`,
  });
}

/** The contents of the first element of this name, with any prefix. @throws Mismatch */
function textOf(xml: string, name: string): string {
  const element = new RegExp(`<((?:[\\w.-]+:)?${name})(?:\\s[^>]*)?>([\\s\\S]*?)</\\1>`).exec(xml);
  must(element !== null, `an element ${name}`, xml);
  return element[2] ?? "";
}
