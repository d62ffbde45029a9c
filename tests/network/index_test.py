"""Indexes of channels over HTTP: forms, copies, credentials, mirrors, and servers that misbehave."""
from __future__ import annotations

import json
import shutil
import unittest

from tests.network.channel_fixture import ChannelCase
from tests.network.fault_server import FOREVER, Fault, FaultServer, self_signed_certificate
from tests.network.shard_writer import write_shards

ZST = "/channel/noarch/repodata.json.zst"


class IndexCase(ChannelCase):
    def setUp(self) -> None:
        super().setUp()
        self.add_package("a", {"share/a": b"a"}, ["b >=1"])
        self.add_package("b", {"share/b": b"b"})
        self.write_index()
        self.keep_forms("repodata.json", "repodata.json.zst")
        self.server = self.enterContext(FaultServer(self.folder))
        self.url = self.server.url + "/channel"

    def asked(self) -> list[str]:
        return [f"{one.path.rsplit('/', 2)[1]}/{one.path.rsplit('/', 1)[1]} {one.status}"
                for one in self.server.behaviour.seen if "/noarch/" in one.path]


class Forms(IndexCase):
    def test_each_form_gives_the_same(self) -> None:
        wanted = [f"b {self.url}/noarch/b-1.0-h_0.conda", f"a {self.url}/noarch/a-1.0-h_0.conda"]
        self.assertEqual(self.solution(self.url, "a"), wanted)
        for form in ("repodata.json.bz2", "repodata.json"):
            shutil.rmtree(self.folder / "cache")
            self.write_index()
            self.keep_forms(form)
            self.server.forget()
            self.assertEqual(self.solution(self.url, "a"), wanted)
            self.assertIn(f"noarch/{form} 200", self.asked())

    def test_damaged_compression_is_said(self) -> None:
        (self.channel / "noarch/repodata.json.zst").write_bytes(b"no zstd")
        self.fail_with("R2W0202", "solve", "-c", self.url, "a")

    def test_no_channel(self) -> None:
        self.fail_with("R2W0201", "solve", "-c", self.server.url + "/nothing", "a")


class Shards(IndexCase):
    """The sharded form gives the same as the flat one, over file and over HTTP."""

    def setUp(self) -> None:
        super().setUp()
        self.add_package("unrelated", {"share/u": b"u"})
        self.write_index()
        for subdir in self.channel.iterdir():
            write_shards(subdir)

    def test_same_solution_flat_and_sharded(self) -> None:
        places = (str(self.channel), f"file://{self.channel}", self.url)
        sharded = [self.succeed("solve", "--json", "-c", place, "a") for place in places]
        asked = self.asked()
        self.assertIn("noarch/repodata_shards.msgpack.zst 200", asked)
        self.assertEqual(len([one for one in asked if one.endswith(".msgpack.zst 200")]), 3, asked)  # list, a, b
        for subdir in self.channel.iterdir():
            (subdir / "repodata_shards.msgpack.zst").unlink()
        shutil.rmtree(self.folder / "cache")
        flat = [self.succeed("solve", "--json", "-c", place, "a") for place in places]
        self.assertEqual(sharded, flat)

    def test_shards_are_kept_by_their_hash(self) -> None:
        first = self.solution(self.url, "a")
        self.server.forget()
        self.assertEqual(self.solution(self.url, "a"), first)
        self.assertEqual(self.asked(), ["noarch/repodata_shards.msgpack.zst 304"])
        self.assertEqual(self.solution(self.url, "a", words=("--offline",)), first)
        self.fail_with("R2W0232", "solve", "--offline", "-c", self.url, "unrelated")

    def test_bases(self) -> None:
        subdir = self.channel / "noarch"
        write_shards(subdir, base_url="../packages/", shards_base_url="shards")
        (subdir / "shards").mkdir(exist_ok=True)
        for shard in subdir.glob("*.msgpack.zst"):
            if "repodata" not in shard.name:
                shard.rename(subdir / "shards" / shard.name)
        wanted = [f"b {self.url}/noarch/../packages/b-1.0-h_0.conda",
                  f"a {self.url}/noarch/../packages/a-1.0-h_0.conda"]
        self.assertEqual(self.solution(self.url, "a"), wanted)

    def test_more_is_promised_than_there_is(self) -> None:
        shards = [f"/channel/noarch/{one.name}" for one in (self.channel / "noarch").glob("*.msgpack.zst")]
        for path in shards:  # nobody says how large they are, so each could go on
            self.server.plan(path, Fault("longer_than_real", 10), FOREVER)
        text = self.fail_with("R2W0233", "solve", "-c", self.url, "a")
        self.assertEqual(text.count("error["), 1, text)
        for path in shards:
            self.server.plan(path, Fault("longer_than_real", 10))
        self.assertEqual(len(self.solution(self.url, "a")), 2)

    def test_damaged_shards(self) -> None:
        for shard in (self.channel / "noarch").glob("*.msgpack.zst"):
            if "repodata" not in shard.name:
                self.server.plan(f"/channel/noarch/{shard.name}", Fault("other_bytes"))
        self.assertEqual(len(self.solution(self.url, "a")), 2)  # once more is enough
        shutil.rmtree(self.folder / "cache")
        for shard in (self.channel / "noarch").glob("*.msgpack.zst"):
            if "repodata" not in shard.name:
                shard.write_bytes(shard.read_bytes()[:-1] + b"?")
        self.fail_with("R2W0238", "solve", "-c", self.url, "a")
        self.fail_with("R2W0238", "solve", "-c", str(self.channel), "a")
        (self.channel / "noarch/repodata_shards.msgpack.zst").write_bytes(b"\x28\xb5\x2f\xfd no")
        self.fail_with("R2W0202", "solve", "-c", self.url, "a")


class Copies(IndexCase):
    def test_not_modified(self) -> None:
        for etags in (True, False):
            with self.subTest(etags=etags):
                shutil.rmtree(self.folder / "cache", ignore_errors=True)
                self.server.behaviour.etags = etags
                first = self.solution(self.url, "a")
                self.server.forget()
                self.assertEqual(self.solution(self.url, "a"), first)
                self.assertEqual(self.asked(), ["noarch/repodata.json.zst 304"])

    def test_a_new_index_is_seen(self) -> None:
        self.solution(self.url, "a")
        self.add_package("c", {"share/c": b"c"})
        self.write_index()
        self.assertEqual(len(self.solution(self.url, "c")), 1)

    def test_missing_forms_are_remembered(self) -> None:
        self.keep_forms("repodata.json")
        self.solution(self.url, "a")
        self.server.forget()
        self.solution(self.url, "a")
        self.assertEqual(self.asked(), ["noarch/repodata.json 304"])

    def test_an_address_may_become_a_channel(self) -> None:
        shutil.move(self.channel, self.folder / "later")
        self.fail_with("R2W0201", "solve", "-c", self.url, "a")
        shutil.move(self.folder / "later", self.channel)
        self.assertEqual(len(self.solution(self.url, "a")), 2)

    def test_a_subdir_may_come_later(self) -> None:
        shutil.move(self.channel / "noarch", self.folder / "later")
        (self.channel / "emscripten-wasm32").mkdir(exist_ok=True)
        shutil.copy(self.folder / "later/repodata.json", self.channel / "emscripten-wasm32")
        (self.channel / "emscripten-wasm32/repodata.json").write_text('{"packages": {}}')
        self.fail_with("R2W0302", "solve", "-c", self.url, "a")
        self.server.forget()
        self.fail_with("R2W0302", "solve", "-c", self.url, "a")
        self.assertEqual(self.asked(), ["noarch/repodata.json 404"])
        shutil.move(self.folder / "later", self.channel / "noarch")
        self.keep_forms("repodata.json", "repodata.json.zst")
        self.assertEqual(len(self.solution(self.url, "a")), 2)

    def test_a_channel_that_is_gone_for_a_moment(self) -> None:
        first = self.solution(self.url, "a")
        shutil.move(self.channel, self.folder / "away")
        self.fail_with("R2W0201", "solve", "-c", self.url, "a")
        self.assertEqual(self.solution(self.url, "a", words=("--offline",)), first)
        shutil.move(self.folder / "away", self.channel)
        self.server.forget()
        self.assertEqual(self.solution(self.url, "a"), first)
        self.assertEqual(self.asked(), ["noarch/repodata.json.zst 304"])

    def test_a_damaged_copy_is_brought_again(self) -> None:
        first = self.solution(self.url, "a")
        for file in (self.folder / "cache").rglob("*repodata.json.zst"):
            file.write_bytes(b"x" + file.read_bytes()[1:])
        self.server.forget()
        self.assertEqual(self.solution(self.url, "a"), first)
        self.assertEqual(self.asked(), ["noarch/repodata.json.zst 200"])

    def test_channel_check_keeps_its_copies_in_the_cache(self) -> None:
        before = sorted(self.folder.iterdir())
        self.succeed("channel", "check", self.server.url + "/${NAME}", NAME="channel",
                     ROS2WASM_AUTH_127_0_0_1="bearer abc")
        self.assertEqual(self.server.behaviour.seen[0].headers["authorization"], "Bearer abc")
        self.assertEqual(sorted(self.folder.iterdir()), sorted([*before, self.folder / "cache"]))

    def test_offline(self) -> None:
        self.fail_with("R2W0232", "solve", "--offline", "-c", self.url, "a")
        self.assertEqual(self.server.behaviour.seen, [])
        first = self.solution(self.url, "a")
        self.server.forget()
        self.assertEqual(self.solution(self.url, "a", words=("--offline",)), first)
        self.assertEqual(self.server.behaviour.seen, [])


class Addresses(IndexCase):
    def test_bare_names_stand_below_the_alias(self) -> None:
        shutil.move(self.channel, self.folder / "moved/conda-forge")
        self.environment["ROS2WASM_CHANNEL_ALIAS"] = self.server.url + "/moved/"
        self.assertEqual(len(self.solution("conda-forge", "a")), 2)
        self.assertEqual(len(self.solution("conda-forge", "conda-forge::a")), 2)
        self.fail_with("R2W0201", "solve", "-c", "conda-forge", "other::a")
        shutil.copytree(self.folder / "moved/conda-forge", self.folder / "moved/conda-forge/label/dev")
        label = self.solution("conda-forge/label/dev", "a")
        self.assertIn("/moved/conda-forge/label/dev/noarch/", label[0])

    def test_a_folder_of_that_name_comes_first(self) -> None:
        self.assertEqual(self.solution("channel", "b"), ["b channel/noarch/b-1.0-h_0.conda"])

    def test_credentials_are_used_and_never_shown(self) -> None:
        shutil.copytree(self.channel, self.folder / "t/s3cret-token/channel")
        for address, header in (
            (self.url.replace("://", "://anna:s3cret-word@"), "Basic YW5uYTpzM2NyZXQtd29yZA=="),
            (self.server.url + "/t/s3cret-token/channel", None),
            (self.server.url + "/t/${TOKEN}/channel", None),
        ):
            with self.subTest(address=address):
                shutil.rmtree(self.folder / "cache", ignore_errors=True)
                self.server.forget()
                done = self.run_cli("solve", "--json", "-c", address, "a", TOKEN="s3cret-token")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(f'"channel":"{self.url}"', done.stdout)
                asked = self.server.behaviour.seen[0]
                self.assertEqual(asked.headers.get("authorization"), header)
                if header is None:
                    self.assertTrue(asked.path.startswith("/t/s3cret-token/"))
                absent = self.run_cli("solve", "-c", address + "/x", "a", TOKEN="s3cret-token")
                kept = "".join(file.read_text(errors="replace")
                               for file in (self.folder / "cache").rglob("*") if file.is_file())
                self.assertIn("R2W0201", absent.stderr)
                self.assertNotIn("s3cret", done.stdout + done.stderr + absent.stderr + kept)
        self.fail_with("R2W0237", "solve", "-c", self.server.url + "/t/${TOKEN}/channel", "a")

    def test_netrc_and_variable(self) -> None:
        (self.folder / ".netrc").write_text("machine 127.0.0.1 login anna password s3cret-word\n")
        of_netrc: dict[str, str] = {}
        for variables, header in ((of_netrc, "Basic YW5uYTpzM2NyZXQtd29yZA=="),
                                  ({"ROS2WASM_AUTH_127_0_0_1": "bearer s3cret"}, "Bearer s3cret")):
            with self.subTest(header=header):
                self.server.forget()
                shown = self.succeed("solve", "--json", "-c", self.url, "a", **variables)
                self.assertEqual(self.server.behaviour.seen[0].headers["authorization"], header)
                shown += self.fail_with("R2W0201", "solve", "-c", self.url + "/x", "a", **variables)
                kept = "".join(file.read_text(errors="replace")
                               for file in (self.folder / "cache").rglob("*") if file.is_file())
                for secret in ("s3cret", header.split(" ")[1]):
                    self.assertNotIn(secret, shown + kept)

    def test_proxy(self) -> None:
        found = self.solution("http://channel.test/channel", "a", http_proxy=self.server.url)
        self.assertEqual(found[0], "b http://channel.test/channel/noarch/b-1.0-h_0.conda")
        self.assertTrue(self.server.behaviour.seen[0].path.startswith("http://channel.test/channel/"))

    def test_refused(self) -> None:
        for form in ("repodata.json.zst", "repodata.json.bz2", "repodata.json"):
            self.server.plan(f"/channel/noarch/{form}", Fault("status", 403), FOREVER)
        self.assertIn("credentials", self.fail_with("R2W0234", "solve", "-c", self.url, "a"))


class OtherPlatforms(IndexCase):
    """What no channel has for sites is looked for among linux-64: only then, and without harm when that fails."""

    def setUp(self) -> None:
        super().setUp()
        native = self.channel / "linux-64"
        native.mkdir()
        record = {"name": "native-only", "version": "1.0", "build": "h_0", "build_number": 0, "depends": []}
        index = {"info": {"subdir": "linux-64"}, "packages.conda": {"native-only-1.0-h_0.conda": record}}
        (native / "repodata.json").write_text(json.dumps(index))

    def asked_for_linux(self) -> list[tuple[str, int]]:
        return [(one.path.rsplit("/", 1)[1], one.status) for one in self.server.behaviour.seen
                if "/linux-64/" in one.path]

    def test_asked_only_when_something_is_missing(self) -> None:
        self.solution(self.url, "a")
        self.assertEqual(self.asked_for_linux(), [])
        text = self.fail_with("R2W0302", "solve", "-c", self.url, "native-only")
        self.assertIn(f"it is there for linux-64 in {self.url}, but has not been built for emscripten-wasm32", text)
        self.assertEqual(self.asked_for_linux()[-1], ("repodata.json", 200))
        self.server.forget()
        self.assertEqual(self.fail_with("R2W0302", "solve", "-c", self.url, "native-only"), text)
        self.assertEqual(self.asked_for_linux(), [("repodata.json", 304)])
        self.server.forget()
        self.assertEqual(self.fail_with("R2W0302", "solve", "--offline", "-c", self.url, "native-only"), text)
        self.assertEqual(self.server.behaviour.seen, [])

    def test_a_name_of_nowhere(self) -> None:
        text = self.fail_with("R2W0302", "solve", "-c", self.url, "nowhere")
        self.assertNotIn("linux-64", text)

    def test_that_it_fails_does_not_matter(self) -> None:
        for fault in (Fault("status", 500), Fault("reset", 0), Fault("login_page")):
            with self.subTest(fault=fault):
                shutil.rmtree(self.folder / "cache", ignore_errors=True)
                self.server.plan("/channel/linux-64/repodata.json", fault, FOREVER)
                text = self.fail_with("R2W0302", "solve", "-c", self.url, "native-only")
                self.assertEqual(text.count("error["), 1, text)
                self.assertNotIn("linux-64", text)


class Faults(IndexCase):
    def test_what_passes_is_tried_again(self) -> None:
        for fault in (Fault("status", 503), Fault("retry_after", (429, "1")), Fault("truncate", 40),
                      Fault("reset", 40)):
            with self.subTest(fault=fault.kind):
                shutil.rmtree(self.folder / "cache", ignore_errors=True)
                self.server.forget()
                self.server.plan(ZST, fault)
                self.assertEqual(len(self.solution(self.url, "a")), 2)
                self.assertEqual(len(self.server.seen(ZST)), 2)

    def test_a_drip_is_given_up(self) -> None:
        self.server.plan(ZST, Fault("drip"))
        self.assertEqual(len(self.solution(self.url, "a", ROS2WASM_STALL_SECONDS="1")), 2)
        self.assertGreater(len(self.server.seen(ZST)), 1)

    def test_what_stays_is_one_error(self) -> None:
        for code, fault in (("R2W0234", Fault("status", 500)), ("R2W0234", Fault("retry_after", (503, "9999"))),
                            ("R2W0233", Fault("reset", 10)), ("R2W0233", Fault("truncate", 10)),
                            ("R2W0236", Fault("redirect", ZST)), ("R2W0236", Fault("redirect", "file:///etc/passwd"))):
            with self.subTest(fault=fault):
                self.server.plan(ZST, fault, FOREVER)
                text = self.fail_with(code, "solve", "-c", self.url, "a")
                self.assertEqual(text.count("error["), 1, text)

    def test_nobody_listens(self) -> None:
        with FaultServer(self.folder) as gone:
            address = gone.url
        self.fail_with("R2W0233", "solve", "-c", address + "/channel", "a")

    def test_redirects_are_followed(self) -> None:
        self.server.plan(ZST, Fault("redirect", "/channel/noarch/repodata.json.zst?again"))
        self.assertEqual(len(self.solution(self.url, "a")), 2)

    def test_certificates(self) -> None:
        pem = self_signed_certificate(self.folder)
        with FaultServer(self.folder, certificate=pem) as server:
            address = server.url + "/channel"
            self.fail_with("R2W0235", "solve", "-c", address, "a")
            self.assertEqual(server.behaviour.seen, [])
            trusted = self.solution(address, "a", SSL_CERT_FILE=str(self.folder / "cert.pem"))
            self.assertEqual(len(trusted), 2)

    def test_json_errors_too(self) -> None:
        self.server.plan(ZST, Fault("status", 500), FOREVER)
        done = self.run_cli("solve", "--json", "-c", self.url, "a")
        codes = [json.loads(line).get("code") for line in done.stderr.splitlines()]
        self.assertEqual([code for code in codes if code], ["R2W0234"])


if __name__ == "__main__":
    unittest.main()
