import { describe, expect, it } from "vitest";
import { addressToOpen, describeConfigProblems, readConfig } from "./config.ts";

describe("readConfig", () => {
  it("needs no settings", () => {
    expect(readConfig({ PATH: "/bin", PORT: "" })).toEqual({
      ok: true,
      config: {
        port: 8080,
        host: null,
        dataDir: "data",
        storeUrl: null,
        publicOrigin: null,
        allowedHosts: null,
        embedOrigins: null,
        gateways: ["ros", "mcp", "soap"],
        trustedProxies: 0,
        metricsPort: null,
        metricsHost: "127.0.0.1",
        drainSeconds: 0,
        logLevel: "warn",
      },
    });
  });

  it("accepts each setting", () => {
    const environment = {
      PORT: "0",
      HOST: "127.0.0.1",
      DATA_DIR: "/var/lib/corridor",
      STORE_URL: "redis://:secret@10.0.0.5:6380/1",
      PUBLIC_URL: "https://robots.example.org/",
      ALLOWED_HOSTS: "Robots.example.org, localhost, [::1]",
      EMBED_ORIGINS: "https://moodle.example.org/, http://localhost:3000",
      GATEWAYS: "mcp, ros",
      TRUSTED_PROXIES: "127.0.0.1, 10.0.0.0/8,fd00::/8",
      LOG_LEVEL: "info",
    };
    expect(readConfig(environment)).toMatchObject({
      config: {
        port: 0,
        host: "127.0.0.1",
        storeUrl: "redis://:secret@10.0.0.5:6380/1",
        publicOrigin: "https://robots.example.org",
        allowedHosts: ["robots.example.org", "localhost", "[::1]"],
        embedOrigins: ["https://moodle.example.org", "http://localhost:3000"],
        gateways: ["mcp", "ros"],
        trustedProxies: ["127.0.0.1", "10.0.0.0/8", "fd00::/8"],
      },
    });
    expect(readConfig({ GATEWAYS: "none" })).toMatchObject({ config: { gateways: [] } });
    expect(readConfig({ TRUSTED_PROXIES: "2" })).toMatchObject({ config: { trustedProxies: 2 } });
  });

  it.each([
    { name: "PORT", value: "http" },
    { name: "PORT", value: "65536" },
    { name: "PORT", value: "-1" },
    { name: "STORE_URL", value: "127.0.0.1:6379" },
    { name: "STORE_URL", value: "http://127.0.0.1:6379" },
    { name: "STORE_URL", value: "redis://" },
    { name: "PUBLIC_URL", value: "robots.example.org" },
    { name: "PUBLIC_URL", value: "ftp://robots.example.org" },
    { name: "PUBLIC_URL", value: "https://robots.example.org/path" },
    { name: "ALLOWED_HOSTS", value: "robots.example.org," },
    { name: "ALLOWED_HOSTS", value: "robots.example.org:443" },
    { name: "ALLOWED_HOSTS", value: "https://robots.example.org" },
    { name: "ALLOWED_HOSTS", value: "*.example.org" },
    { name: "EMBED_ORIGINS", value: "https://moodle.example.org/course" },
    { name: "EMBED_ORIGINS", value: "https://a.example; script-src *" },
    { name: "EMBED_ORIGINS", value: "*" },
    { name: "GATEWAYS", value: "ros,ftp" },
    { name: "GATEWAYS", value: "none,mcp" },
    { name: "TRUSTED_PROXIES", value: "10" },
    { name: "TRUSTED_PROXIES", value: "true" },
    { name: "TRUSTED_PROXIES", value: "10.0.0.0/33" },
    { name: "TRUSTED_PROXIES", value: "10.0.0.1, proxy.local" },
    { name: "TRUSTED_PROXIES", value: "fe80::1/129" },
    { name: "DRAIN_SECONDS", value: "61" },
    { name: "METRICS_PORT", value: "on" },
    { name: "LOG_LEVEL", value: "loud" },
  ])("reports a wrong $name: $value", ({ name, value }) => {
    const result = readConfig({ [name]: value });
    expect(result).toMatchObject({ ok: false, problems: [{ path: name }] });
  });

  it.each([
    "http://robot:hunter2@10.0.0.5:6379",
    "robot:hunter2@10.0.0.5:6379",
    "redis://:hunter2@",
    "hunter2",
  ])("never prints the password of a store: %s", (value) => {
    const result = readConfig({ STORE_URL: value });
    const text = result.ok ? "" : describeConfigProblems(result.problems);
    expect(text).toContain("STORE_URL: found another value");
    expect(text).not.toContain("hunter2");
  });

  it.each([
    { name: "ALLOWED_HOST", nearest: "ALLOWED_HOSTS" },
    { name: "ALLOW_HOSTS", nearest: "ALLOWED_HOSTS" },
    { name: "allowed_hosts", nearest: "ALLOWED_HOSTS" },
    { name: "TRUST_PROXY", nearest: "TRUSTED_PROXIES" },
    { name: "TRSUTED_PROXIES", nearest: "TRUSTED_PROXIES" },
    { name: "PUBLIC_URI", nearest: "PUBLIC_URL" },
    { name: "STORAGE_URL", nearest: "STORE_URL" },
    { name: "METRIC_PORT", nearest: "METRICS_PORT" },
    { name: "METRIC_HOST", nearest: "METRICS_HOST" },
    { name: "LOGLEVEL", nearest: "LOG_LEVEL" },
    { name: "DATADIR", nearest: "DATA_DIR" },
  ])("rejects the misspelt setting $name and suggests $nearest", ({ name, nearest }) => {
    const result = readConfig({ [name]: "1" });
    const text = result.ok ? "" : describeConfigProblems(result.problems);
    expect(text).toContain(`${name}: found an unknown setting, expected ${nearest}`);
  });

  it("ignores the variables of other programs", () => {
    const names = [
      "HOSTNAME",
      "HOME",
      "PATH",
      "PUBLIC_KEY",
      "METRICS_PATH",
      "DATABASE_URL",
      "LOG_FILE",
    ];
    for (const name of names) expect(readConfig({ [name]: "1" }).ok).toBe(true);
    expect(readConfig({ LOG_LEVEL: "info", LOGLEVEL: "3" }).ok).toBe(true);
  });

  it("reports every wrong setting in one message", () => {
    const result = readConfig({ PORT: "x", LOG_LEVEL: "loud" });
    const text = result.ok ? "" : describeConfigProblems(result.problems);
    expect(text).toContain('PORT: found "x", expected a port number');
    expect(text).toContain('LOG_LEVEL: found "loud", expected one of');
  });
});

describe("addressToOpen", () => {
  it.each([
    { environment: {}, address: "http://localhost:8081" },
    { environment: { HOST: "0.0.0.0" }, address: "http://localhost:8081" },
    { environment: { HOST: "192.168.1.5" }, address: "http://192.168.1.5:8081" },
    { environment: { HOST: "fe80::1" }, address: "http://[fe80::1]:8081" },
    {
      environment: { PUBLIC_URL: "https://robots.example.org" },
      address: "https://robots.example.org",
    },
  ])("returns $address", ({ environment, address }) => {
    const settings = readConfig(environment);
    expect(settings.ok && addressToOpen(settings.config, 8081)).toBe(address);
  });
});
