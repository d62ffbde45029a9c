// Behavior trees for tests of bt_navigator, by the names of their files: each has nodes of one kind.

const tree = (body: string): string =>
  `<root BTCPP_format="4" main_tree_to_execute="MainTree">\n  <BehaviorTree ID="MainTree">\n${body}\n  </BehaviorTree>\n</root>\n`;

export const trees: Readonly<Record<string, string>> = {
  tour: tree('    <Sequence><Ring service_name="ring" said="{answer}"/><Say text="{answer}"/><Say text="{text}"/></Sequence>'),
  unknown: tree('    <Fly to="{goal}"/>'),
  absent: tree('    <Spin server_name="nobody/spin"/>'),
  conditions: tree(`
    <Sequence>
      <GetCurrentPose current_pose="{here}"/>
      <ArePosesNear ref_pose="{here}" target_pose="0;map;-2.0;1.0;0;0;0;0;1" tolerance="0.6"/>
      <Inverter><ArePosesNear ref_pose="{here}" target_pose="0;map;2.0;1.0;0;0;0;0;1"/></Inverter>
      <ArePosesNear ref_pose="{here}" target_pose="0;odom;-0.025;2.975;0;0;0;0;1" tolerance="0.6"/>
      <Inverter><GoalReached goal="0;map;2.0;1.0;0;0;0;0;1"/></Inverter>
      <GoalReached goal="{here}"/>
      <TransformAvailable child="base_link" parent="map"/>
      <Inverter><TransformAvailable child="base_link" parent="nowhere"/></Inverter>
      <Inverter><InitialPoseReceived/></Inverter>
      <InitialPoseReceived initial_pose_received="true"/>
      <GlobalUpdatedGoal/>
      <RetryUntilSuccessful num_attempts="200">
        <Delay delay_msec="10"><Sequence><IsBatteryCharging/><IsBatteryLow min_battery="0.2"/></Sequence></Delay>
      </RetryUntilSuccessful>
      <Inverter><IsStuck/></Inverter>
      <SetBlackboard output_key="code" value="207"/>
      <WouldAPlannerRecoveryHelp error_code="{code}"/>
      <Inverter><WouldAControllerRecoveryHelp error_code="{code}"/></Inverter>
      <Inverter><WouldASmootherRecoveryHelp error_code="{code}"/></Inverter>
      <AreErrorCodesPresent error_code="{code}" error_codes_to_check="1;207"/>
      <WouldAControllerRecoveryHelp error_code="105"/>
      <WouldASmootherRecoveryHelp error_code="500"/>
      <Inverter><TimeExpired seconds="0.3"/></Inverter>
      <Inverter><DistanceTraveled distance="0.3"/></Inverter>
      <RetryUntilSuccessful num_attempts="200">
        <Delay delay_msec="10"><PathExpiringTimer seconds="0.3" path="{none}"/></Delay>
      </RetryUntilSuccessful>
      <Say text="all conditions"/>
    </Sequence>`),
  paths: tree(`
    <Sequence>
      <ComputePathToPose goal="{goal}" path="{path}" planner_id="GridBased"/>
      <IsPathValid path="{path}" server_timeout="2000"/>
      <GetPoseFromPath path="{path}" index="-1" pose="{end}"/>
      <ArePosesNear ref_pose="{end}" target_pose="{goal}" tolerance="0.1"/>
      <TruncatePath input_path="{path}" distance="0.5" output_path="{shorter}"/>
      <GetPoseFromPath path="{shorter}" index="-1" pose="{end}"/>
      <Inverter><ArePosesNear ref_pose="{end}" target_pose="{goal}" tolerance="0.4"/></Inverter>
      <TruncatePathLocal input_path="{path}" distance_forward="0.3" distance_backward="0.3" robot_frame="base_link" output_path="{around}"/>
      <GetPoseFromPath path="{around}" index="-1" pose="{end}"/>
      <GetCurrentPose current_pose="{here}"/>
      <ArePosesNear ref_pose="{end}" target_pose="{here}" tolerance="0.45"/>
      <SmoothPath unsmoothed_path="{path}" smoother_id="simple" smoothed_path="{smooth}" was_completed="{done}"/>
      <GetPoseFromPath path="{smooth}" index="0" pose="{end}"/>
      <ArePosesNear ref_pose="{end}" target_pose="{here}" tolerance="0.45"/>
      <ConcatenatePaths input_path1="{around}" input_path2="{path}" output_path="{both}"/>
      <GetPoseFromPath path="{both}" index="-1" pose="{end}"/>
      <ArePosesNear ref_pose="{end}" target_pose="{goal}" tolerance="0.1"/>
      <PlannerSelector selected_planner="{planner}" default_planner="GridBased" topic_name="planner_selector"/>
      <ControllerSelector selected_controller="{controller}" default_controller="FollowPath" topic_name="controller_selector"/>
      <SmootherSelector selected_smoother="{smoother}" default_smoother="simple" topic_name="smoother_selector"/>
      <GoalCheckerSelector selected_goal_checker="{checker}" default_goal_checker="goal_checker" topic_name="goal_checker_selector"/>
      <ProgressCheckerSelector selected_progress_checker="{progress}" default_progress_checker="progress_checker" topic_name="progress_checker_selector"/>
      <PipelineSequence>
        <DistanceController distance="0.5"><ComputePathToPose goal="{goal}" path="{path}" planner_id="{planner}"/></DistanceController>
        <SpeedController min_rate="0.5" max_rate="2.0"><AlwaysSuccess/></SpeedController>
        <GoalUpdatedController><AlwaysSuccess/></GoalUpdatedController>
        <PathLongerOnApproach path="{path}"><AlwaysFailure/></PathLongerOnApproach>
        <GoalUpdater input_goal="{goal}" output_goal="{newest}"><AlwaysSuccess/></GoalUpdater>
        <FollowPath path="{path}" controller_id="{controller}" goal_checker_id="{checker}" progress_checker_id="{progress}"/>
      </PipelineSequence>
      <ClearEntireCostmap service_name="local_costmap/clear_entirely_local_costmap"/>
      <ClearCostmapExceptRegion service_name="local_costmap/clear_except_local_costmap"/>
      <ClearCostmapAroundRobot service_name="local_costmap/clear_around_local_costmap" reset_distance="0.5"/>
      <ClearCostmapAroundPose service_name="local_costmap/clear_around_pose_local_costmap" pose="{goal}" reset_distance="0.5"/>
      <ReinitializeGlobalLocalization service_name="reinitialize_global_localization"/>
      <Say text="all paths"/>
    </Sequence>`),
  behaviours: tree(`
    <Sequence>
      <SingleTrigger><Spin spin_dist="0.5" is_recovery="false"/></SingleTrigger>
      <BackUp backup_dist="0.1" backup_speed="0.1"/>
      <DriveOnHeading dist_to_travel="0.1" speed="0.1"/>
      <RecoveryNode number_of_retries="2">
        <Fallback><Wait wait_duration="0.2"/></Fallback>
        <AlwaysSuccess/>
      </RecoveryNode>
      <RoundRobin><AlwaysFailure/><Wait wait_duration="0.1"/></RoundRobin>
      <CancelSpin/>
      <CancelBackUp/>
      <CancelDriveOnHeading/>
      <CancelWait/>
      <CancelAssistedTeleop/>
      <CancelControl/>
      <AssistedTeleop time_allowance="0.5"/>
      <Say text="all behaviours"/>
    </Sequence>`),
  nested: tree('    <Inverter><NavigateToPose goal="0;map;1.0;1.0;0;0;0;0;1" error_code_id="{code}"/></Inverter>'),
};
