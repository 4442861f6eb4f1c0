import { robotAddresses } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { parseRobotAddress } from "./robot-address.ts";
import { ADDRESS } from "./testing/messages.ts";

describe("parseRobotAddress", () => {
  it("parses an address with surrounding whitespace", () => {
    const address = parseRobotAddress(` ${ADDRESS}\n`);
    expect(address).toEqual({
      origin: "http://localhost:8080",
      id: "AAAAAAAAAAAAAAAAAAAAAA",
      key: "drv_BBBBBBBBBBBBBBBBBBBBBB",
    });
  });

  it.each(robotAddresses.good)("accepts $text", ({ text, ...parts }) => {
    expect(parseRobotAddress(text)).toEqual(parts);
  });

  it.each([undefined, null, 12, ["http://HOST"]])("asks for a text in quotes: %j", (value) => {
    expect(() => parseRobotAddress(value as unknown as string)).toThrow(
      "This is not a robot's address (bad-address). An address is a text in quotes: copy the whole address from the page, under Remote.",
    );
  });

  it.each(robotAddresses.bad)("rejects %j", (text) => {
    expect(() => parseRobotAddress(text)).toThrow(expect.objectContaining({ code: "bad-address" }));
  });

  it.each([
    { name: "nothing", text: "", hint: "empty" },
    {
      name: "the example",
      text: "http://HOST/r/ID#KEY",
      hint: "HOST, ID and KEY stand for your robot's address",
    },
    {
      name: "an address whose key the shell has removed",
      text: ADDRESS.split("#")[0],
      hint: "quotes",
    },
    { name: "an address that ends with #", text: `${ADDRESS.split("#")[0]}#`, hint: "quotes" },
    { name: "an address without http", text: ADDRESS.slice(7), hint: "http://" },
    {
      name: "an address with a user name",
      text: ADDRESS.replace("localhost", "me@localhost"),
      hint: "user name",
    },
    {
      name: "an address with a dot in its id",
      text: "http://localhost:8080/r/AA.A#drv_BBBBBBBB",
      hint: "copy it again",
    },
    { name: "another page", text: "http://localhost:8080/lessons", hint: "copy it again" },
    { name: "a very long text", text: `http://${"x".repeat(100_000)}`, hint: "copy it again" },
  ])("reports what is missing: $name", ({ text, hint }) => {
    expect(() => parseRobotAddress(text ?? "")).toThrow(
      expect.objectContaining({ code: "bad-address", hint: expect.stringContaining(hint) }),
    );
  });
});
